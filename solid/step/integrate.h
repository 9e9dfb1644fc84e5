/* The solid in time: substeps of the integrators.  (001: eqs 3.47, 3.48; SPEC 2) */
#pragma once
#include "base/step_status.h"
#include "solid/state.h"

/* Substeps of the stage's integrator from t on, each with constant load and constant imposed velocities: the means over
 * the substep if these are functions of time. The energies are integrated by the integrator's own quadrature, so that
 * kinetic + strain + e_damped + e_fracture = work_load + e_constraint holds to its order. (The energy stored by contact
 * is not counted; the work of changing an imposed velocity is part of e_constraint.) Collective. */
void solid_integrate(struct solid *s, double dt, int substeps);
/* Finds NaN, and a speed of more than a hundred times the sum of sqrt(E/rho) and the given speed. Not collective. */
struct step_status solid_integrate_check(const struct solid *s);

/* The fraction of a Verlet step at which pairwise damping uses the velocity. A larger one damps the fastest waves more
 * than k_d says, a smaller one damps them less and allows longer steps (solid/step/stable.c; docs/design.md). */
#define SOLID_VERLET_PAIRWISE 0.4

void solid_rk3_step(struct solid *s, double dt);    /* Collective. */
void solid_verlet_begin(struct solid *s);           /* computes a(t_n), unless a is still valid. Collective. */
void solid_verlet_again(struct solid *s);           /* computes a(t_n) with changed loads and imposed velocities. Not
                                                     * collective. */
void solid_verlet_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_end(struct solid *s);             /* Not collective. */
/* During a sweep: v_old becomes the present a, the part that depends on d and on velocity differences only; a is
 * scratch until solid_force_rest. Not collective. */
void solid_verlet_keep(struct solid *s);
/* Continues in the middle of a stage, from a checkpoint's d, v, v_old (for Verlet: the accelerations of the last sweep,
 * which used the velocity predicted then) and power_pairwise. To be called once the stage is set. Not collective. */
void solid_verlet_resume(struct solid *s);
