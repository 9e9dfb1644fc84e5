/* The solid in time: substeps of the integrators.  (001: eqs 3.47, 3.48, mended) */
#pragma once
#include "base/step_status.h"
#include "solid/state.h"

/* Substeps of the stage's integrator from t on, each with constant load and constant imposed velocities: the means over
 * the substep if these are functions of time. The energies are integrated by the integrator's own quadrature, so that
 * kinetic + strain + e_damped + e_fracture = work_load + e_constraint holds to its order. (The energy stored by contact
 * is not counted; the work of changing an imposed velocity is part of e_constraint.) Of
 * SOLID_INTEGRATE_MANY substeps or more a request to stop the program leaves out the rest: s->stops says so, and the
 * state is then not that of a step. Collective. */
enum { SOLID_INTEGRATE_MANY = 100 };
void solid_integrate(struct solid *s, double dt, int substeps);
/* Finds NaN, a speed of more than a hundred times the sum of sqrt(E/rho) and the given speed, and an implicit contact
 * that was not solved in the last call of solid_integrate. Not collective. */
struct step_status solid_integrate_check(const struct solid *s);

/* What an integrator is: one line of solid_integrate_kind. */
enum { SOLID_INTEGRATORS = SOLID_VERLET + 1 };
struct solid_integrator_kind {
    const char *name;
    int sweeps;                               /* force sweeps a substep */
    void (*begin)(struct solid *s);           /* before the first of some substeps. Collective. */
    void (*again)(struct solid *s);           /* before a later one, where loads or imposed velocities have changed.
                                               * Not collective. */
    void (*step)(struct solid *s, double dt); /* Collective. */
    void (*end)(struct solid *s);             /* after the last one. Not collective. */
};
const struct solid_integrator_kind *solid_integrate_kind(enum solid_integrator integrator);

/* Number of force sweeps of the stage's integrator in this number of substeps. Not collective. */
long solid_integrate_sweeps(const struct solid *s, int substeps);
/* Continues in the middle of a stage, from a checkpoint's d, v, v_old (for Verlet: the accelerations of the last sweep,
 * which used the velocity predicted then) and power_pairwise. To be called once the stage is set. Not collective. */
void solid_integrate_resume(struct solid *s);
