/* What of a plate falls to each of its particles, of whatever levels. Inside the room only.
 *
 * A particle's cell is four quarters of half its side. A quarter of a level's cell is itself four, each a quarter of
 * one cell of the next level: so every place has one cell on each level, and belongs to the finest that has a particle.
 */
#pragma once
#include "solid/refine/plan.h"

/* Of the body in each cell of the lattice, kept from one refinement to the next. */
struct solid_refine_cells {
    int low[2], n[2];
    double *area; /* [n[1]][n[0]] cells, NAN: not looked at yet */
};

void solid_refine_area_new(struct solid_refine_cells *cells, const struct solid_cloud *cloud);
void solid_refine_area_free(struct solid_refine_cells *cells);

/* volume [plan->n] spacings^2: sets those near particles of a level above 0, to 2^-40; what is as it was before keeps
 * its bits. */
void solid_refine_area(const struct solid_refine_plan *plan, struct solid_refine_cells *cells, double *volume);
/* Adds to length [plan->n] the boundary from one point to the other, m; 0 where it does not run so, and text says why.
 */
int solid_refine_area_length(const struct solid_refine_plan *plan, const double from[2], const double to[2],
                             double *length, char *text, size_t size);
