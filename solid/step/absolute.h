/* The exact work of absolute damping with velocity Verlet.
 *
 * A substep from n to n+1 changes the kinetic energy by the works of all forces, the mean of their values at both ends
 * times the displacement (solid/step/verlet.c). With u for the velocity with which the damping -k_a rho u was computed,
 * damping takes
 *     sum of 1/2 k_a rho V (u(n) + u(n+1)) . (d(n+1) - d(n))
 * e_damped has the mean of the powers k_a rho V u^2 at both ends, which differs from this in second order. The
 * difference goes to damped_missed. For solid/ only. */
#pragma once
#include "solid/state.h"

struct solid_absolute; /* opaque: u(n) */
void solid_absolute_free(struct solid_absolute *absolute);
/* Once a has been computed with damping at the present v, outside of a substep: keeps u(n) = v. Nothing without
 * absolute damping. Not collective, nor is any function here. */
void solid_absolute_begin(struct solid *s);
/* In a substep, once a has been computed with damping at the present v = v(n) + dt a_old, plus contact's change: adds
 * to damped_missed, and keeps u(n+1) = v. */
void solid_absolute_end(struct solid *s, double dt);
