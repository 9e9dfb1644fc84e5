/* The rates of a solid's bonds, by Lanczos iteration. */
#pragma once
#include "solid/step/stable.h"

/* For the intact body with the stage's damping, accurate to about 1e-3. Collective. */
void solid_rates_of(struct solid *s, struct solid_rates *rates);
/* The largest rate of the present bonds about the present displacements, 1/s2, accurate to about 1e-3. A bond of
 * stretch s that is turned by the angle of its ends' motion resists that motion with s/(1 + s) of its stiffness, and
 * stretched bonds turn towards the stretch: so a stretched solid is stiffer than at rest. Takes 10 to 60 sweeps; the
 * last sweep's forces hold afterwards as before. Collective. */
double solid_rates_strained(struct solid *s);
/* The sum of mass times x.y over the particles of all ranks, x, y [n]. Collective. */
double solid_rates_product(const struct solid *s, double *const x[3], double *const y[3]);
/* Rates that were found before for the same solid with this pairwise damping. */
struct solid_rates_found {
    int known;
    double damping_relative;
    struct solid_rates rates;
};
/* Returns 1 and sets *rates if the rates are the present stage's too. They, and the steps that follow, are then to the
 * bit what solid_rates_of would give. Not collective. */
int solid_rates_again(struct solid *s, const struct solid_rates_found *found, struct solid_rates *rates);
/* The largest stable step of the intact solid with the stage's damping, by the rates of solid/step/stable.h: without
 * damping sqrt(3)/omega_max (RK3), 2/omega_max (Verlet). If contact has lists, the contact of a particle squeezed
 * between two pairs of others is added. Collective. */
double solid_rates_stable_step(struct solid *s, enum solid_integrator integrator);
