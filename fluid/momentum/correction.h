/* The pressure correction's planes on their way from the Poisson solver to the velocities, from the top down: with
 * slabs two planes that take turns, as plane k is used with k+1 only; where y is cut over ranks a whole array, because
 * a row of every plane comes from the next rank. */
#pragma once
#include "fluid/internal.h"

/* memory_free ends it. */
double *fluid_correction_new(const struct fluid_grid *g);
/* q = predicted - c grad phi + shift on all faces inside the domain and on open sides, p += phi in the cells and in
 * those ghosts that the momentum equation reads; one layer of q's ghosts, a plane's while it is in the cache. phi from
 * the solver, after its solve. q may be predicted. Collective. */
void fluid_correction_apply(struct fluid *f, double c, double *const q[3]);
