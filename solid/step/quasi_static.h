/* Raises loads and imposed displacements in increments through states of equilibrium, with bonds that break in between.
 */
#pragma once
#include "solid/state.h"

struct solid_quasi_static {
    long relaxations;  /* steps of all relaxations of the increment */
    int rounds;        /* times that bonds broke and the solid relaxed again */
    long broken;       /* bonds broken in the increment, whole solid */
    double dissipated; /* energy that the relaxations took where bonds broke or the solid snapped, J, whole solid */
    int moves_away;    /* no equilibrium, because a part that nothing holds moves away */
};

/* One increment: loads and imposed displacements go to their values at t, the solid relaxes to |residual| <= tolerance
 * times the load or the reaction (or the force that breaks one particle's cross-section, whichever is largest). Then
 * all bonds beyond the limit break or soften at once, and it relaxes again, until none is and it is at rest. Returns
 * whether it is in equilibrium at the end: 0 if a relaxation has taken max_steps or moves away (found), and the bonds
 * that broke before that stay broken. The works of loads and constraints are added to work_load and e_constraint by the
 * trapezoidal rule. Where bonds break, or the solid leaves an unstable equilibrium (it buckles), the next state of rest
 * has less energy: what the relaxations take is added to e_damped. Collective. */
int solid_quasi_static_step(struct solid *s, double t, double tolerance, int max_steps,
                            struct solid_quasi_static *found);
