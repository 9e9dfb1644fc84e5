/* The energy that a step of RK3 takes from a solid.
 *
 * A step multiplies a mode of frequency omega, which has no damping, by R(i z), z = omega dt, and its energy E by
 *     |R(i z)|^2 = 1 - z^4/12 + z^6/36          R(z) = 1 + z + z^2/2 + z^3/6
 * The accelerations of its three stages differ by
 *     e_1 = a_1 - a_0 = -8/15 dt K v,      e_2 = a_2 - a_1 = -2/15 dt K v - 2/9 dt^2 K a_0
 * (physics/rk3.h) with K for stiffness over mass. So K v and K a_0 are known, and with them the sum over all modes of
 *     omega^4 E = 1/2 |K v|^2 + 1/2 a_0.K a_0          omega^6 E = |K a_0|^2
 * The latter is the mean over a period: its exact value would need K K v. For solid/ only. */
#pragma once
#include "solid/state.h"

/* begin: after the force sweep of the first stage. end: after that of the third, while a_old still is that of the
 * second; it adds the loss to e_integrator. Not collective. */
void solid_rk3_loss_begin(struct solid *s);
void solid_rk3_loss_end(struct solid *s, double dt);
void solid_rk3_loss_free(struct solid_rk3_loss *loss);
