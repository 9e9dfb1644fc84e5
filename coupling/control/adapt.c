/* Chooses the time step and the number of solid substeps, and decides whether a step that was taken is accepted. */
#include "coupling/control/adapt.h"
#include "base/die.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/run.h"
#include "base/files/log.h"
#include "fluid/scheme.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/step/stable.h"

#include <math.h>
#include <stdio.h>

enum { LOOK_AT_CONTACT_EVERY = 4, FEWER_SUBSTEPS_EVERY = 100, SUBSTEPS_MAX = 1000000 };

/* An automatic step is at most GROWTH times the last one. It is rejected if it is longer than the limit of the new
 * velocities, by more than BEYOND times the scene's fraction of that limit. */
static const double GROWTH = 1.2, BEYOND = 1.1;
/* Factors of the step for another try: SHORTER after NaN; else from the limit, between SHORTEST and LONGEST. A step
 * below LEAST of the stage's first one is not tried. */
static const double SHORTER = 0.25, SHORTEST = 1e-3, LONGEST = 0.9, LEAST = 1e-6;
enum { DOUBLINGS = 6, SAID_AFTER = 10 };

const char *const adapt_bound_name[] = {"the scene", "convection", "diffusion", "growth", "a step made again"};

static const struct scene_stage *stage_of(const struct run *r) { return &r->scene->stage[r->stage]; }
static int is_automatic(const struct run *r) { return r->fluid && stage_of(r)->time_step <= 0; }
static int has_substeps(const struct run *r) { return r->substeps > 0 && stage_of(r)->substeps == 0; }

void adapt_begin(struct run *r) {
    r->adapt.limits_of = -1;
    r->adapt.most = INFINITY;
    r->adapt.least = r->adapt.tries = r->adapt.usual = 0;
    r->adapt.first = 0;
    r->adapt.said = ADAPT_GIVEN;
    if (r->stage_step == 0) r->adapt.approach = 0;
}

/* Writes one line if another bound has limited the last steps. */
static void say_bound(struct run *r) {
    struct adapt *a = &r->adapt;
    if (a->replays || a->bound == a->said || (a->said != ADAPT_GIVEN && a->since < SAID_AFTER)) return;
    log_line("step %ld: time step %.4g s, bound by %s", r->step, r->dt, adapt_bound_name[a->bound]);
    a->said = a->bound;
}

static void bounded_by(struct run *r, enum adapt_bound bound) {
    r->adapt.since = bound == r->adapt.bound ? r->adapt.since + 1 : 1;
    r->adapt.bound = bound;
}

void adapt_time_step(struct run *r) {
    struct adapt *a = &r->adapt;
    const double before = r->stage_step > 0 ? GROWTH * r->dt : 0;
    if (a->limits_of != r->step) a->limits = fluid_limits_stable_step(r->fluid);
    enum adapt_bound bound = a->limits.convective < a->limits.viscous ? ADAPT_CONVECTION : ADAPT_DIFFUSION;
    r->dt = stage_of(r)->cfl * a->limits.step;
    if (before > 0 && r->dt > before) r->dt = before, bound = ADAPT_GROWTH;
    if (r->dt > a->most) r->dt = a->most, bound = ADAPT_AGAIN;
    if (!(a->first > 0)) a->first = r->dt;
    bounded_by(r, bound);
    say_bound(r);
}

static double least_substeps(const struct run *r, double stable) {
    return ceil(r->dt / (stage_of(r)->safety * stable) * (1 - 1e-12));
}

/* Speed of this rank's fastest particle, m/s. */
static double fastest_of(const struct solid *s) {
    const int plane = s->dim == 2; /* in a plate the third component is 0: the second array stands for it, times 0 */
    const double *restrict u = s->v[0], *restrict v = s->v[1], *restrict w = s->v[s->dim - 1];
    const double third = !plane;
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        const double v2 = u[h] * u[h] + v[h] * v[h] + third * (w[h] * w[h]);
        most = v2 > most ? v2 : most;
    }
    return sqrt(most);
}

/* Whether the substep depends on the particles' speed. */
static int needs_speed(const struct run *r) { return has_substeps(r) && solid_contact_rate_margin(r->solid) > 0; }

/* Whether the present number of substeps is stable with contact of this rate. */
static int suffices(const void *run, double contact) {
    const struct run *r = run;
    const enum solid_integrator integrator = r->solid->stage.integrator;
    return least_substeps(r, solid_stable_of(&r->solid_rates, integrator, contact, NULL)) <= r->substeps;
}

/* Sets the stable step. Implicit contact has no limit of stability, but particles must not pass one another within a
 * substep. */
static double find_stable(struct run *r, double fastest, solid_contact_enough *enough) {
    const struct solid *s = r->solid;
    const int is_implicit = solid_contact_implicit_is(s);
    const double contact = is_implicit ? 0 : solid_contact_rate_bound(r->solid, enough, r),
                 passing = is_implicit ? solid_contact_implicit_step(s, fastest) : INFINITY;
    r->adapt.approach = 0;
    r->solid_stable = solid_stable_of(&r->solid_rates, s->stage.integrator, contact, &r->solid_bound);
    if (passing < r->solid_stable) {
        r->solid_stable = passing;
        r->solid_bound = SOLID_BOUND_CONTACT;
    }
    return contact;
}

static int wanted(struct run *r, double fastest, solid_contact_enough *enough) {
    const double contact = find_stable(r, fastest, enough);
    const double least = least_substeps(r, r->solid_stable);
    if (least > SUBSTEPS_MAX && contact == 0) /* with contact, such a number may be needed for a while */
        die_all(EXIT_CODE_SCENE,
                "stage %s: a step of %g s would take %.3g solid substeps (stable up to %.3g s), at most %d",
                stage_of(r)->name, r->dt, least, r->solid_stable, SUBSTEPS_MAX);
    /* one in each stage of the fluid where the load has a step of its own; without bonds there is no limit */
    const double fewest = r->load_kind && r->load_kind->step ? fluid_scheme_stages(r->fluid) : 1;
    return (int)fmin(fmax(least, fewest), SUBSTEPS_MAX);
}

/* Speed of the fastest particle of all ranks, m/s; 0 where no substep depends on it. */
static double fastest_now(const struct run *r) {
    return solid_contact_implicit_is(r->solid) && needs_speed(r) ? par_max(fastest_of(r->solid)) : 0;
}

int adapt_substeps_wanted(struct run *r) { return wanted(r, fastest_now(r), NULL); }

static void set_substeps(struct run *r, int substeps) {
    if (r->substeps > 0 && !r->adapt.replays)
        log_line("step %ld: %d solid substeps, bound by %s (stable up to %.4g s)", r->step, substeps,
                 solid_stable_bound_name[r->solid_bound], r->solid_stable);
    r->substeps = substeps;
}

/* The contact's rate is computed every few steps, or at every step if the step is automatic. The number of substeps
 * rises at once, but falls only every FEWER_SUBSTEPS_EVERY steps: it is part of a checkpoint, so the steps at which it
 * may fall are fixed. */
void adapt_substeps(struct run *r) {
    const int least = r->adapt.least;
    if (is_automatic(r) || r->substeps == 0 || r->stage_step % LOOK_AT_CONTACT_EVERY == 0) {
        const int may_fall = r->stage_step % FEWER_SUBSTEPS_EVERY == 0;
        const int least_now = wanted(r, fastest_now(r), may_fall ? NULL : suffices);
        if (least_now > r->substeps || (least_now < r->substeps && may_fall)) set_substeps(r, least_now);
    }
    if (r->substeps < least) r->substeps = least;
}

void adapt_look(const struct run *r, int failed, double number[ADAPT_NUMBERS]) {
    number[ADAPT_FAILED] = failed;
    number[ADAPT_RATE] = is_automatic(r) && !failed ? fluid_limits_convection_rate(r->fluid, NULL) : 0;
    number[ADAPT_FASTEST] = !failed && needs_speed(r) ? fastest_of(r->solid) : 0;
}

static void say_again(struct run *r, const char *how, const char *why) {
    r->adapt.tries++;
    if (!r->adapt.replays) log_line("step %ld: made again with %s: %s", r->step, how, why);
}

enum { FAULT_MAX = 192 };

/* What was found, in words. */
static void tell_fault(const struct step_status *s, char why[FAULT_MAX]) {
    snprintf(why, FAULT_MAX, "%s = %.4g at (%.6g, %.6g, %.6g) m on rank %d", s->field, s->value, s->x[0], s->x[1],
             s->x[2], s->rank);
}

static enum adapt_verdict shorter(struct run *r, double dt, const struct step_status *s) {
    char how[64], why[FAULT_MAX];
    if (!(dt > 0 && dt >= LEAST * r->adapt.first)) return ADAPT_LOST; /* 0: shorter than any number */
    r->adapt.most = dt;
    snprintf(how, sizeof how, "%.4g s instead of %.4g s", dt, r->dt);
    tell_fault(s, why);
    say_again(r, how, why);
    return ADAPT_MAKE_AGAIN;
}

static enum adapt_verdict finer(struct run *r, int substeps, const char *why) {
    char how[64];
    if (r->adapt.tries >= DOUBLINGS || substeps > SUBSTEPS_MAX) return ADAPT_LOST;
    r->adapt.least = substeps;
    snprintf(how, sizeof how, "%d solid substeps instead of %d", substeps, r->substeps);
    say_again(r, how, why);
    return ADAPT_MAKE_AGAIN;
}

static enum adapt_verdict judge_failure(struct run *r, struct step_status *status) {
    char why[FAULT_MAX];
    step_status_agree(status);
    if (is_automatic(r)) return shorter(r, SHORTER * r->dt, status);
    tell_fault(status, why);
    return status->seen_in == STEP_STATUS_SOLID && has_substeps(r) ? finer(r, 2 * r->substeps, why) : ADAPT_LOST;
}

static enum adapt_verdict judge_convection(struct run *r, double rate, struct step_status *status) {
    struct adapt *a = &r->adapt;
    const double cfl = stage_of(r)->cfl;
    a->limits = fluid_limits_of(r->fluid, rate);
    a->limits_of = r->step;
    if (r->dt <= fmax(BEYOND * cfl, 1) * a->limits.convective) return ADAPT_HOLDS;
    *status = (struct step_status){.seen_in = STEP_STATUS_COUPLING, .rank = par_rank(), .field = "convection"};
    status->failed = fluid_limits_convection_rate(r->fluid, status->x) == rate;
    status->value = r->dt / a->limits.convective;
    step_status_agree(status);
    return shorter(r, fmin(fmax(cfl * a->limits.step, SHORTEST * r->dt), LONGEST * r->dt), status);
}

/* Contact that is not implicit: the bound on its rate includes pairs within a margin, before they touch. It is computed
 * again before two particles can have approached by more than the margin. */
static enum adapt_verdict judge_contact(struct run *r, double fastest, struct step_status *status) {
    r->adapt.approach += 2 * r->dt * fastest;
    if (solid_contact_implicit_is(r->solid) ? r->dt <= solid_contact_implicit_step(r->solid, fastest) * r->substeps
                                            : r->adapt.approach <= solid_contact_rate_margin(r->solid))
        return ADAPT_HOLDS;
    const int least = wanted(r, fastest, suffices);
    if (r->dt > r->solid_stable * r->substeps * (1 + 1e-12)) {
        char why[96];
        snprintf(why, sizeof why, "bound by %s (stable up to %.4g s)", solid_stable_bound_name[r->solid_bound],
                 r->solid_stable);
        *status = (struct step_status){
            .failed = 1, .seen_in = STEP_STATUS_COUPLING, .field = "substep", .value = r->dt / r->substeps};
        return finer(r, least, why);
    }
    if (least > r->substeps) set_substeps(r, least);
    return ADAPT_HOLDS;
}

static void count(struct run *r) {
    if (r->adapt.replays) return;
    if (is_automatic(r)) r->adapt.ruled[r->adapt.bound]++;
    if (has_substeps(r)) r->adapt.substeps_ruled[r->solid_bound]++;
}

enum adapt_verdict adapt_judge(struct run *r, const double number[ADAPT_NUMBERS], struct step_status *status) {
    enum adapt_verdict verdict = ADAPT_HOLDS;
    if (number[ADAPT_FAILED] > 0) return judge_failure(r, status);
    if (is_automatic(r)) verdict = judge_convection(r, number[ADAPT_RATE], status);
    if (verdict == ADAPT_HOLDS && needs_speed(r)) verdict = judge_contact(r, number[ADAPT_FASTEST], status);
    if (verdict == ADAPT_HOLDS) count(r);
    return verdict;
}

static int follows(const struct run *r) {
    for (int k = 0; k < r->parts; k++)
        if (r->part[k] == adapt_substeps) return 1;
    return 0;
}

void adapt_again(struct run *r) {
    if (r->adapt.least <= r->substeps || follows(r)) return;
    const int may_refine = r->scene->solid->refinement != NULL; /* which may need the larger number from here on */
    if (!r->adapt.usual && !may_refine) r->adapt.usual = r->substeps;
    r->substeps = r->adapt.least;
}

void adapt_made(struct run *r) {
    r->adapt.again += r->adapt.tries;
    if (r->adapt.usual) r->substeps = r->adapt.usual;
    r->adapt.usual = 0;
    r->adapt.tries = r->adapt.least = 0;
    r->adapt.most = INFINITY;
}

void adapt_explain(struct run *r, double dt, int substeps, char *text, size_t size) {
    const char *name = "nothing"; /* a solid without bonds has no limit */
    double most = 0, stable = INFINITY;
    int of_solid = 0;
    if (r->fluid) {
        const struct fluid_limits l = fluid_limits_stable_step(r->fluid);
        name = l.convective < l.viscous ? adapt_bound_name[ADAPT_CONVECTION] : adapt_bound_name[ADAPT_DIFFUSION];
        stable = l.step;
        most = stable > 0 ? dt / stable : INFINITY;
    }
    if (substeps > 0) {
        adapt_substeps_wanted(r);
        of_solid = dt / substeps > most * r->solid_stable;
        if (of_solid) {
            name = solid_stable_bound_name[r->solid_bound];
            stable = r->solid_stable;
            most = dt / substeps / stable;
        }
    }
    const double step = of_solid ? dt / substeps : dt;
    const char *what = of_solid ? "solid's substep" : "step";
    if (!isfinite(stable))
        snprintf(text, size, "nothing limits the %s of %.4g s in the last good state", what, step);
    else if (!(stable > 0))
        snprintf(text, size, "no %s is short enough for %s: its limit is 0 s", what, name);
    else if (most <= 1)
        snprintf(text, size,
                 "no limit of the last good state was exceeded: the %s of %.4g s is %.3g of what %s would allow", what,
                 step, most, name);
    else if (of_solid)
        snprintf(text, size, "the %s of %.4g s is %.3g times what %s would allow, %.4g s: %.0f substeps would do", what,
                 step, most, name, stable, ceil(dt / (stage_of(r)->safety * stable)));
    else
        snprintf(text, size, "the %s of %.4g s is %.3g times what %s would allow, %.4g s", what, step, most, name,
                 stable);
}
