/* The force sweep, and its parts for the integrators.  (001: eqs 3.37-3.39) */
#pragma once
#include "solid/state.h"

/* One force sweep at the present d, v: a = (bonds + load + contact + damping)/rho, constraints applied; breaks bonds if
 * may_break is set and the stage allows it. The integrators set it in the first stage of a substep only, so that a bond
 * breaks on the state of a full step, never on that of an inner Runge-Kutta stage. Ghosts must be current. Collective
 * only through contact. */
void solid_force(struct solid *s, int may_break);

/* a = (bonds + pairwise damping k_d)/rho of all bodies; sets power_damped. If an exchange of ghosts was begun: computes
 * bonds without ghosts first, then waits for the ghosts and computes the rest; it is then collective. */
void solid_force_bonds(struct solid *s, int may_break, double damping_relative);
/* Resets the form in which each bond was computed, which no checkpoint holds: the next sweep depends on d, v and the
 * bonds alone. Not collective. */
void solid_force_reset(struct solid *s);
/* a = bonds + load/rho + body force - k_a v, bonds[3] [n] (may be a); sets power_load, power_damped. Not collective. */
void solid_force_loads(struct solid *s, double *const bonds[3], double damping_absolute);
/* a = the part that depends on pairs: bonds, pairwise damping at the present v, contact. Collective only through
 * contact. */
void solid_force_pairs(struct solid *s, int may_break);
/* a = pairs + loads, absolute damping at the present v, added mass, constraints; and their powers. pairs[3] [n]: what
 * solid_force_pairs has found; may be a. Not collective. */
void solid_force_rest(struct solid *s, double *const pairs[3]);
