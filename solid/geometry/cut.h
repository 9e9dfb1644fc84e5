/* Which bonds an initial crack crosses. Not collective.  (003: ch. 3, cracks as polylines) */
#pragma once
#include "solid/state.h"

/* 1: the input is not a valid crack, and text says why in one sentence. A plate's crack has two points or more, a
 * solid's has the four corners of a plane, convex quadrilateral. Tolerances are fractions of its extent. */
int solid_cut_fault(const struct solid_cut *cut, int dim, char *text, size_t size);

/* A crack of a plate with its points rounded to multiples of 2^-20 of a lattice's spacing, twice the tolerance of
 * solid/geometry/on_surface.h. */
struct solid_cut_line {
    int points;
    int64_t (*point)[2]; /* in 2^-32 spacings from the lattice's origin; owned */
};

struct solid_cut_line *solid_cut_line_new(const struct solid_cut *cut, const double origin[2], double spacing);
void solid_cut_line_free(struct solid_cut_line *line);
/* 1: the bond from a to b (in spacings from the origin, multiples of 2^-32) meets the crack. Exact, so that both ends
 * and mirror images agree. Touching counts: a bond that ends on the crack is broken, and a crack through a row of
 * particles breaks all their bonds. So a crack should run between rows. */
int solid_cut_line_crosses(const struct solid_cut_line *line, const double a[2], const double b[2]);

/* 1: the bond from a to b meets the quadrilateral; touching counts (solid/geometry/on_surface.h). The result for b to a
 * is the same. All lengths are in the same unit, whatever it is. */
int solid_cut_plane_crosses(const double (*corner)[3], const double a[3], const double b[3], double spacing);
