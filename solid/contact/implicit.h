/* Contact over a substep of velocity Verlet, implicit in the displacements.
 *
 * Bonds and loads kick the particles at both ends of a substep. Between the kicks the particles move under contact
 * alone, by a midpoint rule whose force on a pair is the discrete gradient of its potential
 * (solid/contact/repulsion.h):
 *
 *     d(1) = d* + dt^2/2 C/rho      v <- v + dt C/rho      C = sum over l of k_c V_l slope (zeta_0 + zeta_1)
 *
 * with d* = d(0) + dt v + dt^2/2 a the displacement without contact. This motion conserves kinetic energy plus
 * contact's potential, momentum and angular momentum for any step. For linear bonds the whole substep conserves the sum
 * over their modes of (1/2) v^2 + (1/2) omega^2 x^2/(1 - omega^2 dt^2/4), with v and x in the middle of the substep,
 * plus contact's potential. So contact does not lower the stable step of the bonds.  (docs/design/solid-motion.md)
 *
 * d(1) is found by Chebyshev's iteration (solid/contact/implicit_solve.c): with contact's stiffness bounded by beta =
 * dt^2/4 max_h |sum 2 kappa/rho e e| the linearised equations have eigenvalues between 1 and 1 + beta. */
#pragma once
#include "base/step_status.h"
#include "solid/state.h"

/* Whether contact is implicit in the present stage: with velocity Verlet, unless a push (solid/step/push.h) needs all
 * forces at the beginning of a substep. Otherwise contact's force is part of the acceleration (solid_contact_force). */
int solid_contact_implicit_is(const struct solid *s);
/* Before and after the prediction of d and v. The second one changes d and v of the particles in contact, and adds
 * to e_constraint, work_load and the reactions; the ghosts must be exchanged afterwards. Both need s->contact.
 * Collective.
 */
void solid_contact_implicit_begin(struct solid *s);
void solid_contact_implicit_end(struct solid *s, double dt);
/* Whether the iteration of a substep has failed to converge since the last reset. The value is the residual over the
 * largest acceleration by contact. Not collective. */
struct step_status solid_contact_implicit_status(const struct solid *s);
void solid_contact_implicit_reset(struct solid *s);
/* The acceleration C/rho along c with which contact moved an owned particle in the last substep, 0 where c is imposed,
 * m/s2. Not collective. */
double solid_contact_implicit_push(const struct solid *s, int h, int c);
/* The sum over particles of density volume (f + sign g).C/rho, with f and g [n] accelerations, W/s; this rank's share.
 * Not collective. */
double solid_contact_implicit_along(const struct solid *s, double *const f[3], double sign, double *const g[3]);
/* The longest substep in which no two particles approach by more than a fifth of r_c, s; fastest: speed of the fastest
 * particle, m/s. INFINITY: no pairs are near. Not collective. */
double solid_contact_implicit_step(const struct solid *s, double fastest);
