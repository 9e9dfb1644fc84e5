/* The surface of a body on the lattice: a union of convex shapes, minus the shapes of its holes and its cavities, with
 * the images of all of them across periodic sides. A grid of cells holds who is near a place, so that a depth costs the
 * same for one sphere and for a thousand. */
#pragma once
#include "solid/geometry/shape.h"

struct solid_compound_member {
    double low[3], high[3]; /* its bounds, m */
    double shift[3];        /* from the shape to this image of it, m */
    long first;             /* its first piece */
    int pieces, is_hole;
    int is_small; /* at most two spacings across, and near only what is within half a spacing */
    int shape;    /* number of the shape in the body, the same for all images */
};

struct solid_compound {
    double spacing;         /* m */
    int shapes;             /* without holes */
    double low[3], high[3]; /* bounds of the shapes as they are given, without images, m */
    int is_wrapped[3]; /* periodic, and the body extends beyond a side or, of several shapes, from side to side: it has
                        * images across the sides */
    long members, small;
    struct solid_compound_member *member; /* [members] */
    struct solid_piece *piece;            /* of a hole: turned, so that the material is outside the hole */
    struct solid_shape_surface cavities;  /* its period and cavity alone */
    /* cells: the members that are within two spacings of each, of small members half a spacing */
    double origin[3], width[3]; /* m */
    int cells[3];
    long *start; /* [cells + 1] */
    int *item;
    long tested; /* members whose depth was computed so far */
};

/* For a body that is not on the lattice NULL. in: spacing, periodic sides and their lengths. Dies (exit 2) on a body
 * that reaches too far. Collective (same input on all ranks); nothing below is. */
struct solid_compound *solid_compound_new(const struct solid_input *in, const struct solid_body *body);
void solid_compound_free(struct solid_compound *compound);

/* Depth of x below the body's surface, m: exact at the surface, elsewhere a number of the same sign; -INFINITY where
 * nothing is near. */
double solid_compound_depth(struct solid_compound *compound, const double x[3]);
/* Where the depth is -INFINITY, the surface is at least so far away, m. */
double solid_compound_unseen(const struct solid_compound *compound);
/* The number of the shape that x lies deepest in; of several that differ by less than the tolerance of
 * solid/geometry/on_surface.h the lowest. -1: in none. */
int solid_compound_shape(struct solid_compound *compound, const double x[3]);
/* The members near x, and how many: [n] indices. */
const int *solid_compound_near(const struct solid_compound *compound, const double x[3], int *n);
/* The k-th piece of a member, or its cavity next to x for k = pieces. Returns 0 where there is no such piece. */
int solid_compound_piece(const struct solid_compound *compound, const struct solid_compound_member *member, int k,
                         const double x[3], struct solid_piece *piece);
