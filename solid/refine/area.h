/* The area of a plate that belongs to each of its particles, of any level. For solid/ only.
 *
 * A particle's cell consists of four quarters of half its side. A quarter of a level's cell consists of four smaller
 * ones, each a quarter of one cell of the next level. So every point lies in one cell of each level, and belongs to the
 * finest level that has a particle there. */
#pragma once
#include "solid/refine/plan.h"

/* Area of the body in each cell of the lattice, kept from one refinement to the next. */
struct solid_refine_cells {
    int low[2], n[2];
    double *area; /* [n[1]][n[0]] cells, NAN: not computed yet */
};

void solid_refine_area_new(struct solid_refine_cells *cells, const struct solid_cloud *cloud);
void solid_refine_area_free(struct solid_refine_cells *cells);

/* Sets volume [plan->n], spacings^2, of the particles near those of a level above 0, rounded to 2^-40; unchanged
 * volumes keep their bits. */
void solid_refine_area(const struct solid_refine_plan *plan, struct solid_refine_cells *cells, double *volume);
/* Adds the boundary between two points to length [plan->n], m. Returns 0, with a reason in text, if no boundary joins
 * the points. */
int solid_refine_area_length(const struct solid_refine_plan *plan, const double from[2], const double to[2],
                             double *length, char *text, size_t size);
