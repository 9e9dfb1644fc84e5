/* Indenters: rigid spheres, in a plate discs, that push the particles inside them outward. For solid/ and tests.
 *
 *     f = K (R - r)^2 (x - x_k)/r  per volume, r = |x - x_k| < R     x_k = centre + velocity t
 *
 * That is the force of LAMMPS's fix indent, -K (r - R)^2 along the radius, on the force densities of its package PERI,
 * whose K therefore has the unit N/m5 too. It is minus the gradient of the energy density (K/3) (R - r)^3. The force on
 * a body is an integral over its volume, so it does not depend on the spacing. At the centre it has no direction, and
 * is taken as 0. An indenter moves as the scene says, whatever pushes it back. */
#pragma once
#include "solid/state.h"

struct solid_indent {
    double t;           /* s, the time for which the places hold */
    double (*place)[3]; /* [indenters] m */
    double (*force)[3]; /* [indenters] on the solid in the last sweep, this rank's share, N */
    double *energy;     /* [indenters] of the last sweep, this rank's share, J */
    long *inside;       /* [indenters] particles inside, this rank's */
};

/* Sets s->indent; NULL if the input has no indenter. Not collective. */
void solid_indenter_new(struct solid *s);
void solid_indenter_free(struct solid_indent *indent);
/* Moves the indenters to their places at t. Does nothing without indenters. */
void solid_indenter_place(struct solid *s, double t);
/* Adds the forces to a and their power to power_load; s->indent must not be NULL. Not collective. */
void solid_indenter_push(struct solid *s);
/* An upper bound of the force's stiffness over the density, 2 K R/rho summed over the indenters, 1/s2. */
double solid_indenter_rate(const struct solid *s);
/* An upper bound of the speed that the indenters give to a free particle, m/s. */
double solid_indenter_speed(const struct solid *s);
