/* Loads that conserve momentum: each body's sum is corrected to the force that the forcing takes from the fluid. */
#pragma once
#include "coupling/run.h"

/* Corrects the loads. To be called after the probes' loads and before those of particles without bonds, which come from
 * the forcing and are left out. sum: the probes' force on the whole solid, this rank's share, N; corrected.
 * Collective. */
void balance_loads(struct run *r, double sum[3]);
/* After the solid's part of a step: stores the force that accelerated each body's carried mass, which the next step
 * gives back. Does nothing unless loads are balanced and the scheme is explicit. Collective. */
void balance_keep(struct run *r);
