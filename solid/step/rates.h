/* The rates of a solid, by Lanczos's iteration on the assembled bonds. */
#pragma once
#include "solid/step/stable.h"

/* By Lanczos's iteration on the intact body, for the stage's damping; good to about 1e-3. Collective. */
void solid_rates_of(struct solid *s, struct solid_rates *rates);
/* The largest stable step of the assembled, intact solid with the stage's damping, by the rates of solid/step/stable.h:
 * without damping sqrt(3)/omega_max (RK3), 2/omega_max (Verlet). Once contact has lists, with a particle squeezed
 * between two pairs of others on top. Collective. */
double solid_rates_stable_step(struct solid *s, enum solid_integrator integrator);
