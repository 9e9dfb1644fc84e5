/* Takes the pressure correction's planes from the Poisson solver, top plane first, and corrects the velocities. The
 * correction is needed at planes k and k+1 only, so slabs keep two planes that swap roles (with threads, one more than
 * there are threads). If y is cut over ranks a whole array is kept, because one row of every plane comes from the next
 * rank. */
#pragma once
#include "fluid/internal.h"
#include "fluid/momentum/momentum.h"

size_t fluid_correction_work(const struct fluid_grid *g); /* doubles of f->correction. Not collective. */
/* q = predicted - c grad phi + shift on all faces inside the domain and on open sides; the pressures change by phi in
 * the cells and in the ghosts that the momentum equation reads. Fills one ghost layer of q, of each plane while it is
 * in the cache. phi is the solver's solution. q may be predicted. Collective. */
void fluid_correction_apply(struct fluid *f, double c, const struct fluid_momentum_pressure *pressure,
                            double *const q[3]);
