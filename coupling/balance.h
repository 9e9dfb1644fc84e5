/* Loads that keep momentum: each body's sum made to agree with what the forcing takes from the fluid. */
#pragma once
#include "coupling/run.h"

/* Between the probes' loads and those of particles without bonds, which are the forcing's already and left out. sum:
 * the probes' force on the whole solid, this rank's share, N; corrected. Collective. */
void balance_loads(struct run *r, double sum[3]);
/* After the solid's part of a step: what it took to move the mass that each body carries, which the next step gives
 * back; nothing unless loads are balanced and the scheme is explicit. Collective. */
void balance_keep(struct run *r);
