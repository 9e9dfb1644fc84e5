/* Advances the solid by substeps with the stage's integrator, and checks it for faults. */
#include "solid/step/integrate.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/signals.h"
#include "base/step_status.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/walls.h"
#include "solid/step/balance.h"
#include "solid/step/push.h"
#include "solid/step/rk3.h"
#include "solid/step/verlet.h"

#include <math.h>
#include <stdio.h>

static void nothing(struct solid *s) { (void)s; }

static const struct solid_integrator_kind rk3 = {"RK3", 3, nothing, nothing, solid_rk3_step, nothing};
static const struct solid_integrator_kind verlet = {
    "velocity Verlet", 1, solid_verlet_begin, solid_verlet_again, solid_verlet_step, solid_verlet_end};

const struct solid_integrator_kind *solid_integrate_kind(enum solid_integrator integrator) {
    switch (integrator) {
    case SOLID_RK3:
        return &rk3;
    case SOLID_VERLET:
        return &verlet;
    }
    ENSURE(0, "integrator %d", (int)integrator);
}

long solid_integrate_sweeps(const struct solid *s, int substeps) {
    return (long)substeps * solid_integrate_kind(s->stage.integrator)->sweeps;
}

void solid_integrate_resume(struct solid *s) { solid_integrate_kind(s->stage.integrator)->end(s); }

/* Sets loads and imposed velocities of the coming substep. Returns whether one of them may have changed. */
static int impose(struct solid *s, double dt) {
    const int varies = solid_constraint_varies(s);
    if (varies) solid_constraint_velocity(s, s->t, dt);
    return solid_external_loads_update(s, s->t, dt) | varies;
}

void solid_integrate(struct solid *s, double dt, int substeps) {
    if (s->stops) return;
    clock_begin(CLOCK_SOLID);
    const struct solid_integrator_kind *kind = solid_integrate_kind(s->stage.integrator);
    const int may_meet = s->in.contact && (s->contact || s->in.bodies > 1);
    const int is_fast = (may_meet || s->walls) && solid_contact_is_fast(s, substeps * dt);
    const double start = s->t;
    struct signals_poll_state poll = {0};
    solid_contact_implicit_reset(s);
    solid_balance_begin(s);
    solid_walls_list(s);
    for (int i = 0; i < substeps; i++) {
        if (substeps >= SOLID_INTEGRATE_MANY && (s->stops = signals_poll(&poll))) break;
        if (is_fast && i > 0)
            solid_contact_update(s);
        else
            solid_contact_update_broken(s);
        if (is_fast && i > 0) solid_walls_list(s);
        const int changed = impose(s, dt);
        if (i == 0)
            kind->begin(s);
        else if (changed)
            kind->again(s);
        if (s->push) s->push->before(s, dt, s->push->with);
        kind->step(s, dt);
        s->t = start + (i + 1) * dt;
    }
    kind->end(s);
    clock_end(CLOCK_SOLID);
}

/* The speed that the input gives: velocities imposed or of the start, and the speed of a free particle under all forces
 * up to now, m/s. */
static double speed_given(const struct solid *s) {
    double speed = s->in.speed, force = 0, lightest = INFINITY, push = 0;
    for (int k = 0; k < s->in.constraints; k++)
        for (int c = 0; c < s->dim; c++) speed = fmax(speed, fabs(s->in.constraint[k].velocity[c]));
    for (int b = 0; b < s->in.bodies; b++)
        for (int c = 0; c < s->dim; c++) speed = fmax(speed, fabs(s->in.body[b].velocity[c]));
    for (int k = 0; k < s->in.loads; k++)
        for (int c = 0; c < s->dim; c++)
            force += fabs(s->in.load[k].force[c]) + fabs(s->in.load[k].traction[c]) / s->in.spacing;
    for (int m = 0; m < s->in.materials; m++) lightest = fmin(lightest, s->in.material[m].density);
    for (int c = 0; c < s->dim; c++) push += fabs(s->in.body_force[c]);
    if (s->indent) speed += solid_indenter_speed(s);
    return speed + (push + force / lightest) * s->t;
}

/* A particle cannot be faster than the waves plus the given speed. Far beyond that the solution is meaningless, even if
 * it is still finite. */
enum { SPEEDS_ALLOWED = 100 };

static double speed_limit(const struct solid *s) {
    double most = 0;
    for (int m = 0; m < s->in.materials; m++)
        most = fmax(most, s->in.material[m].youngs_modulus / s->in.material[m].density);
    return SPEEDS_ALLOWED * (sqrt(most) + speed_given(s));
}

/* The first particle whose displacement or speed is not finite, or whose speed is above the limit; -1: none. */
static int first_lost(const struct solid *s, int c, double limit) {
    for (int h = 0; h < s->n; h++)
        if (!isfinite(s->d[c][h]) || !(fabs(s->v[c][h]) <= limit)) return h;
    return -1;
}

struct step_status solid_integrate_check(const struct solid *s) {
    struct step_status status = {0};
    const double limit = speed_limit(s);
    for (int c = 0; c < s->dim; c++) {
        const double *restrict d = s->d[c], *restrict v = s->v[c];
        double lost = 0, fastest = 0; /* lost: NaN if a number is not finite, which `fastest` does not show */
#pragma omp simd reduction(max : fastest) reduction(+ : lost)
        for (int h = 0; h < s->n; h++) {
            const double speed = fabs(v[h]);
            fastest = speed > fastest ? speed : fastest;
            lost += 0 * d[h] + 0 * v[h];
        }
        if (lost == 0 && fastest <= limit) continue;
        const int h = first_lost(s, c, limit);
        if (h < 0) continue;
        const int bad_d = !isfinite(s->d[c][h]);
        status.failed = 1;
        status.seen_in = STEP_STATUS_SOLID;
        status.rank = par_rank();
        status.value = bad_d ? s->d[c][h] : s->v[c][h];
        for (int k = 0; k < s->dim; k++) status.x[k] = s->x0[k][h];
        snprintf(status.field, sizeof status.field, bad_d ? "displacement" : "solid velocity");
        break;
    }
    return status.failed ? status : solid_contact_implicit_status(s);
}
