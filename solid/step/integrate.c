/* Advances the solid by substeps with the stage's integrator, and checks it for NaN and too large speeds. */
#include "solid/step/integrate.h"
#include "base/clock.h"
#include "base/par.h"
#include "base/step_status.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/given.h"

#include <math.h>
#include <stdio.h>

/* Loads and imposed velocities of the coming substep; returns whether one may have changed. */
static int impose(struct solid *s, double dt) {
    const int varies = solid_constraint_varies(s);
    if (varies) solid_constraint_velocity(s, s->t, dt);
    return solid_given_set(s, s->t, dt) | varies;
}

static void rk3(struct solid *s, double dt, int substeps) {
    const double start = s->t;
    for (int i = 0; i < substeps; i++) {
        impose(s, dt);
        solid_rk3_step(s, dt);
        s->t = start + (i + 1) * dt;
    }
}

static void verlet(struct solid *s, double dt, int substeps) {
    const double start = s->t;
    for (int i = 0; i < substeps; i++) {
        const int changed = impose(s, dt);
        if (i == 0)
            solid_verlet_begin(s);
        else if (changed)
            solid_verlet_again(s);
        solid_verlet_step(s, dt);
        s->t = start + (i + 1) * dt;
    }
    solid_verlet_end(s);
}

void solid_integrate(struct solid *s, double dt, int substeps) {
    clock_begin(CLOCK_SOLID);
    switch (s->stage.integrator) {
    case SOLID_RK3:
        rk3(s, dt, substeps);
        break;
    case SOLID_VERLET:
        verlet(s, dt, substeps);
        break;
    }
    clock_end(CLOCK_SOLID);
}

/* What is given: velocities, and what forces make of a free particle up to now, m/s. */
static double speed_given(const struct solid *s) {
    double speed = s->in.speed, force = 0, lightest = INFINITY, push = 0;
    for (int k = 0; k < s->in.constraints; k++)
        for (int c = 0; c < s->dim; c++) speed = fmax(speed, fabs(s->in.constraint[k].velocity[c]));
    for (int k = 0; k < s->in.loads; k++)
        for (int c = 0; c < s->dim; c++)
            force += fabs(s->in.load[k].force[c]) + fabs(s->in.load[k].traction[c]) / s->in.spacing;
    for (int m = 0; m < s->in.materials; m++) lightest = fmin(lightest, s->in.material[m].density);
    for (int c = 0; c < s->dim; c++) push += fabs(s->in.body_force[c]);
    return speed + (push + force / lightest) * s->t;
}

/* Nothing moves faster than waves do and what drives it; well beyond that the numbers have no meaning, though they may
 * still be finite. */
enum { SPEEDS_ALLOWED = 100 };

static double speed_limit(const struct solid *s) {
    double most = 0;
    for (int m = 0; m < s->in.materials; m++)
        most = fmax(most, s->in.material[m].youngs_modulus / s->in.material[m].density);
    return SPEEDS_ALLOWED * (sqrt(most) + speed_given(s));
}

/* The first particle whose displacement is no number, or whose speed is none or beyond the limit; -1: none. */
static int first_lost(const struct solid *s, int c, double limit) {
    for (int h = 0; h < s->n; h++)
        if (!isfinite(s->d[c][h]) || !(fabs(s->v[c][h]) <= limit)) return h;
    return -1;
}

struct step_status solid_integrate_check(const struct solid *s) {
    struct step_status status = {0};
    const double limit = speed_limit(s);
    for (int c = 0; c < s->dim; c++) {
        double sum = 0, fastest = 0;
        for (int h = 0; h < s->n; h++) {
            sum += fabs(s->d[c][h]) + fabs(s->v[c][h]);
            fastest = fmax(fastest, fabs(s->v[c][h]));
        }
        if (isfinite(sum) && fastest <= limit) continue;
        const int h = first_lost(s, c, limit);
        if (h < 0) continue;
        const int bad_d = !isfinite(s->d[c][h]);
        status.failed = 1;
        status.rank = par_rank();
        status.value = bad_d ? s->d[c][h] : s->v[c][h];
        for (int k = 0; k < s->dim; k++) status.x[k] = s->x0[k][h];
        snprintf(status.field, sizeof status.field, bad_d ? "displacement" : "solid velocity");
        break;
    }
    return status;
}
