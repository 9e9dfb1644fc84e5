/* The solid in time: substeps of the integrators.  (001: eqs 3.47, 3.48, mended) */
#pragma once
#include "base/step_status.h"
#include "solid/state.h"

/* Substeps of the stage's integrator from t on, each under constant load and with constant imposed velocities: where
 * these are given as functions of time, their means over the substep. The energies are integrated by the integrator's
 * own quadrature, so that kinetic + strain + e_damped + e_fracture = work_load + e_constraint holds to its order
 * (contact stores energy that is not counted; what it takes to change an imposed velocity is part of e_constraint).
 * Collective. */
void solid_integrate(struct solid *s, double dt, int substeps);
/* NaN, or a speed of more than a hundred times sqrt(E/rho) and what is imposed. Not collective. */
struct step_status solid_integrate_check(const struct solid *s);

/* The part of a Verlet step at which pairwise damping sees the velocity. A later one damps the fastest waves more than
 * it is asked to, an earlier one less, and takes longer steps (solid/step/stable.c; docs/design/solid.md). */
#define SOLID_VERLET_PAIRWISE 0.4

void solid_rk3_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_begin(struct solid *s);        /* a(t_n), anew unless it is still right. Collective. */
void solid_verlet_again(struct solid *s);        /* a(t_n) with other loads and imposed velocities. Not collective. */
void solid_verlet_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_end(struct solid *s);             /* Not collective. */
/* Within a sweep: v_old becomes the present a, the part that depends on d and on differences of v alone; a is scratch
 * until solid_force_rest. Not collective. */
void solid_verlet_keep(struct solid *s);
/* Goes on in the middle of a stage, from a checkpoint's d, v, v_old (for Verlet: the accelerations of the last sweep,
 * which saw the velocity predicted then) and power_pairwise. Once the stage is set. Not collective. */
void solid_verlet_resume(struct solid *s);
