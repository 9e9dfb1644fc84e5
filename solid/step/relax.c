/* Adaptive dynamic relaxation to static equilibrium.  (Underwood 1983; Kilic and Madenci 2010) */
#include "base/clock.h"
#include "base/par.h"
#include "base/signals.h"
#include "base/files/log.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/reactions.h"
#include "solid/step/balance.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"

#include <math.h>
#include <string.h>

/* Central differences with the damping that is critical for the frequency of the present deformation, the Rayleigh
 * quotient of the displacement since the start.  (Underwood 1983; Kilic and Madenci 2010)
 *     v = ((2 - c dt) v + 2 dt a)/(2 + c dt)      d += dt v      c = 2 sqrt(-u.M a_bonds / u.M u) */

static const double OF_STABLE_STEP = 0.9;
static const double OF_FIRST = 1e-6; /* of the first residual: what a solid that nothing loads or supports comes to */
static const double AWAY = 10;       /* lengths of the domain: what has moved by more is held by nothing */
static const double SILENT = 20;     /* s */
enum { CHECK_EVERY = 100 };          /* steps between two checks of how far it has moved */

struct sums {
    double residual2, load2, reaction2; /* N2 */
    double stiffness, mass;             /* u.K u, u.M u */
};

/* Computes a at the present d and v = 0, and the sums for the step and the stop criterion. Collective. */
static struct sums sweep(struct solid *s, double *const start[3]) {
    solid_ghosts_update(s);
    solid_force_bonds(s, 0, 0);
    if (s->in.contact && s->contact) solid_contact_force(s);
    double sum[5] = {0};
    for (int h = 0; h < s->n; h++) {
        const double density = solid_density(s, h), mass = density * s->volume[h];
        for (int c = 0; c < s->dim; c++) {
            const double force = s->volume[h] * (s->load[c][h] + density * s->in.body_force[c]);
            if (s->flag[h] & SOLID_HELD_X << c) continue;
            const double u = s->d[c][h] - start[c][h];
            sum[1] += force * force;
            sum[3] -= mass * u * s->a[c][h];
            sum[4] += mass * u * u;
        }
    }
    solid_force_loads(s, s->a, 0);
    solid_reactions_find(s);
    sum[2] = solid_constraint_apply(s);
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++) sum[0] += mass * s->a[c][h] * mass * s->a[c][h];
    }
    par_sum_array(sum, 5);
    return (struct sums){sum[0], sum[1], sum[2], sum[3], sum[4]};
}

/* Of a solid that is strained at the start, or by the displacement of held particles, K u is not -M a, and the quotient
 * above would go to 0 with the residual. So here u is the last step's displacement, dt v, and K u = -M (a - last): as
 * the fast modes come to rest, the frequency falls to that of the slowest. last: the acceleration of the last sweep;
 * becomes the present one. Collective. */
static void moving_quotient(const struct solid *s, double dt, double *const last[3], struct sums *sums) {
    double sum[2] = {0};
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++) {
            const double u = dt * s->v[c][h];
            if (s->flag[h] & SOLID_HELD_X << c) continue;
            sum[0] -= mass * u * (s->a[c][h] - last[c][h]);
            sum[1] += mass * u * u;
        }
    }
    for (int c = 0; c < s->dim; c++) memcpy(last[c], s->a[c], (size_t)s->n * sizeof(double));
    par_sum_array(sum, 2);
    sums->stiffness = sum[0];
    sums->mass = sum[1];
}

/* 1: a particle has moved by more than AWAY since the start. A domain without lengths has no such limit. Collective. */
static int moves_away(const struct solid *s, double *const start[3]) {
    double most = 0, length = 0;
    for (int c = 0; c < s->dim; c++) {
        length = fmax(length, s->in.length[c]);
        for (int h = 0; h < s->n; h++) most = fmax(most, fabs(s->d[c][h] - start[c][h]));
    }
    return length > 0 && par_max(most) > AWAY * length;
}

/* A line of the log every SILENT seconds. */
static void log_residual(const struct solid *s, double *logged, int step, double residual, double tolerance) {
    if (par_seconds() - *logged < SILENT) return;
    *logged = par_seconds();
    log_line("relaxation: %d steps so far, residual %.2g, tolerance %g; %ld bonds broken in the run", step, residual,
             tolerance, s->bonds_broken);
}

/* Contact's lists follow the particles. Returns whether the first ones were made, which the stable step counts.
 * Collective. */
static int follow_contact(struct solid *s) {
    const int had = s->contact != NULL;
    solid_contact_update(s);
    return !had && s->contact;
}

/* When a residual is small enough: at `tolerance` times the load, the reaction or `least`, N, whichever is largest, or
 * at `part` of the first one. */
struct aim {
    double tolerance, least, part;
};

/* last: NULL for a solid without displacement. */
static int relax(struct solid *s, const struct aim *aim, int max_steps, double *const start[3], double *const last[3]) {
    const int touches = s->contact || s->in.bodies > 1; /* not a crack's faces, but in increments */
    if (touches) follow_contact(s);
    double dt = OF_STABLE_STEP * solid_rates_stable_step(s, SOLID_VERLET);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            s->v[c][h] = 0;
            start[c][h] = s->d[c][h];
        }
    double logged = par_seconds(), first2 = 0;
    struct signals_poll_state poll = {0};
    for (int i = 0; i <= max_steps; i++) {
        if (touches && follow_contact(s)) dt = OF_STABLE_STEP * solid_rates_stable_step(s, SOLID_VERLET);
        struct sums sum = sweep(s, start);
        if (last) moving_quotient(s, dt, last, &sum);
        if (i == 0) first2 = sum.residual2;
        const double reference2 =
            fmax(fmax(sum.load2, sum.reaction2), fmax(aim->least * aim->least, OF_FIRST * OF_FIRST * first2));
        if (sum.residual2 <= fmax(aim->tolerance * aim->tolerance * reference2, aim->part * aim->part * first2))
            return i;
        if (!isfinite(sum.residual2)) return SOLID_RELAX_TOO_LONG;
        if (i % CHECK_EVERY == CHECK_EVERY - 1 && moves_away(s, start)) return SOLID_RELAX_AWAY;
        if ((s->stops = signals_poll(&poll))) return SOLID_RELAX_STOPPED;
        log_residual(s, &logged, i, sqrt(sum.residual2 / reference2), aim->tolerance);
        const double c_dt = sum.mass > 0 ? fmin(2 * dt * sqrt(fmax(sum.stiffness / sum.mass, 0)), 1.9) : 0;
        const double keep = (2 - c_dt) / (2 + c_dt), gain = (i ? 2 : 1) * dt / (i ? 2 + c_dt : 2);
        for (int c = 0; c < s->dim; c++)
            for (int h = 0; h < s->n; h++) {
                s->v[c][h] = keep * s->v[c][h] + gain * s->a[c][h];
                s->d[c][h] += dt * s->v[c][h];
            }
    }
    return SOLID_RELAX_TOO_LONG;
}

static int begin(struct solid *s, const struct aim *aim, int max_steps, double *const last[3]) {
    clock_begin(CLOCK_SOLID);
    const double put_in = s->e_constraint;
    solid_balance_end(s);
    solid_constraint_displacement(s, s->t);
    solid_external_loads_update(s, s->t, 0);
    const int steps = relax(s, aim, max_steps, s->v_old, last);
    solid_reactions_begin(s);
    solid_reactions_add(s, 1, 0); /* of the last sweep; the length of the step does not matter */
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->v[c][h] = 0;
    solid_constraint_velocity(s, s->t, 0);
    s->e_constraint = put_in;
    solid_ghosts_update(s);
    s->a_holds = 0;
    clock_end(CLOCK_SOLID);
    return steps;
}

/* 1: a particle is displaced, as by a stage before, an initial displacement or a constraint. Collective. */
static int is_displaced(struct solid *s) {
    double most = 0;
    solid_constraint_displacement(s, s->t);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) most = fmax(most, fabs(s->d[c][h]));
    return par_max(most) > 0;
}

int solid_relax(struct solid *s, double tolerance, int max_steps) {
    const struct aim aim = {.tolerance = tolerance};
    return begin(s, &aim, max_steps, is_displaced(s) ? s->a_old : NULL);
}

int solid_relax_strained(struct solid *s, double tolerance, double least, double part, int max_steps) {
    const struct aim aim = {tolerance, least, part};
    return begin(s, &aim, max_steps, s->a_old);
}
