/* The rates of a solid's bonds, by Lanczos iteration. */
#pragma once
#include "solid/step/stable.h"

/* For the intact body with the stage's damping, accurate to about 1e-3. Collective. */
void solid_rates_of(struct solid *s, struct solid_rates *rates);
/* The largest stable step of the intact solid with the stage's damping, by the rates of solid/step/stable.h: without
 * damping sqrt(3)/omega_max (RK3), 2/omega_max (Verlet). If contact has lists, the contact of a particle squeezed
 * between two pairs of others is added. Collective. */
double solid_rates_stable_step(struct solid *s, enum solid_integrator integrator);
