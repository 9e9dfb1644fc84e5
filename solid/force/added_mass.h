/* Added mass: an external force -m (a.n) n per unit volume, proportional to the particle's own acceleration a along a
 * unit vector n, as the pressure of a fluid that must make way. It is part of the mass, not of the load: explicit, it
 * would feed on the acceleration of the step before and grow at the short waves, whatever the step. */
#pragma once

struct solid;

struct solid_added_mass {
    int n;
    const int *h;            /* [n] owned particle; may repeat, once a wetted face */
    const double *normal[3]; /* [n] unit */
    const double *density;   /* [n] m, kg per m3 of the particle */
};

/* a <- (rho I + sum m n n^T)^-1 rho a for the listed particles, and the power of the force to s->power_load. Each face
 * in turn, by the Sherman-Morrison formula: exact for one face or two opposite ones. Not collective. */
void solid_added_mass_apply(struct solid *s);
