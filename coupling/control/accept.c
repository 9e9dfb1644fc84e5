/* Decides whether a step that was taken is accepted. */
#include "coupling/control/accept.h"
#include "base/files/log.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/control/substeps.h"
#include "coupling/control/time_step.h"
#include "coupling/run.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"

#include <math.h>
#include <stdio.h>

/* An automatic step is rejected if it is longer than the limit of the new velocities, by more than BEYOND times the
 * scene's fraction of that limit. */
static const double BEYOND = 1.1;
/* Factors of the step for another try: SHORTER after NaN; else from the limit, between SHORTEST and LONGEST. A step
 * below LEAST of the stage's first one is not tried. */
static const double SHORTER = 0.25, SHORTEST = 1e-3, LONGEST = 0.9, LEAST = 1e-6;
enum { DOUBLINGS = 6 };

void accept_numbers(const struct run *r, int failed, double number[ACCEPT_NUMBERS]) {
    number[ACCEPT_FAILED] = failed;
    number[ACCEPT_RATE] = time_step_is_automatic(r) && !failed ? fluid_limits_convection_rate(r->fluid, NULL) : 0;
    number[ACCEPT_FASTEST] = !failed && substeps_need_speed(r) ? substeps_fastest(r->solid) : 0;
}

static void log_repeat(struct run *r, const char *how, const char *why) {
    r->control.repeats++;
    if (!r->control.replays) log_line("step %ld: made again with %s: %s", r->step, how, why);
}

enum { FAULT_MAX = 192 };

/* What was found, in words. */
static void print_fault(const struct step_status *s, char why[FAULT_MAX]) {
    snprintf(why, FAULT_MAX, "%s = %.4g at (%.6g, %.6g, %.6g) m on rank %d", s->field, s->value, s->x[0], s->x[1],
             s->x[2], s->rank);
}

static enum accept_verdict repeat_shorter(struct run *r, double dt, const struct step_status *s) {
    char how[64], why[FAULT_MAX];
    if (!(dt > 0 && dt >= LEAST * r->control.dt_first)) return ACCEPT_ABORT; /* 0: shorter than any number */
    r->control.dt_max = dt;
    snprintf(how, sizeof how, "%.4g s instead of %.4g s", dt, r->dt);
    print_fault(s, why);
    log_repeat(r, how, why);
    return ACCEPT_REPEAT;
}

static enum accept_verdict repeat_finer(struct run *r, int substeps, const char *why) {
    char how[64];
    if (r->control.repeats >= DOUBLINGS || substeps > SUBSTEPS_MAX) return ACCEPT_ABORT;
    r->control.substeps_min = substeps;
    snprintf(how, sizeof how, "%d solid substeps instead of %d", substeps, r->substeps);
    log_repeat(r, how, why);
    return ACCEPT_REPEAT;
}

static enum accept_verdict check_failure(struct run *r, struct step_status *status) {
    char why[FAULT_MAX];
    step_status_agree(status);
    if (time_step_is_automatic(r)) return repeat_shorter(r, SHORTER * r->dt, status);
    print_fault(status, why);
    return status->seen_in == STEP_STATUS_SOLID && substeps_are_automatic(r) ? repeat_finer(r, 2 * r->substeps, why)
                                                                             : ACCEPT_ABORT;
}

static enum accept_verdict check_convection(struct run *r, double rate, struct step_status *status) {
    struct step_control *a = &r->control;
    const double cfl = run_stage(r)->cfl;
    a->limits = fluid_limits_of(r->fluid, rate);
    a->limits_step = r->step;
    if (r->dt <= fmax(BEYOND * cfl, 1) * a->limits.convective) return ACCEPT_STEP;
    *status = (struct step_status){.seen_in = STEP_STATUS_COUPLING, .rank = par_rank(), .field = "convection"};
    status->failed = fluid_limits_convection_rate(r->fluid, status->x) == rate;
    status->value = r->dt / a->limits.convective;
    step_status_agree(status);
    return repeat_shorter(r, fmin(fmax(cfl * a->limits.step, SHORTEST * r->dt), LONGEST * r->dt), status);
}

/* Contact that is not implicit: the bound on its rate includes pairs within a margin, before they touch. It is computed
 * again before two particles can have approached by more than the margin. */
static enum accept_verdict check_contact(struct run *r, double fastest, struct step_status *status) {
    r->control.approach += 2 * r->dt * fastest;
    const int no_contact = !(solid_contact_rate_margin(r->solid) > 0);
    if (no_contact && substeps_may_skip(r, fastest)) return ACCEPT_STEP;
    if (no_contact                            ? 0
        : solid_contact_implicit_is(r->solid) ? r->dt <= solid_contact_implicit_step(r->solid, fastest) * r->substeps
                                              : r->control.approach <= solid_contact_rate_margin(r->solid))
        return ACCEPT_STEP;
    const int least = substeps_for(r, fastest, substeps_suffice);
    if (r->dt > r->solid_stable * r->substeps * (1 + 1e-12)) {
        char why[96];
        snprintf(why, sizeof why, "bound by %s (stable up to %.4g s)", solid_stable_bound_name[r->solid_bound],
                 r->solid_stable);
        *status = (struct step_status){
            .failed = 1, .seen_in = STEP_STATUS_COUPLING, .field = "substep", .value = r->dt / r->substeps};
        return repeat_finer(r, least, why);
    }
    if (least > r->substeps) substeps_set(r, least);
    return ACCEPT_STEP;
}

static void count(struct run *r) {
    if (r->control.replays) return;
    if (time_step_is_automatic(r)) r->control.bound_steps[r->control.bound]++;
    if (substeps_are_automatic(r)) r->control.substep_bound_steps[r->solid_bound]++;
}

enum accept_verdict accept_step(struct run *r, const double number[ACCEPT_NUMBERS], struct step_status *status) {
    enum accept_verdict verdict = ACCEPT_STEP;
    if (number[ACCEPT_FAILED] > 0) return check_failure(r, status);
    if (time_step_is_automatic(r)) verdict = check_convection(r, number[ACCEPT_RATE], status);
    if (verdict == ACCEPT_STEP && substeps_need_speed(r)) verdict = check_contact(r, number[ACCEPT_FASTEST], status);
    if (verdict == ACCEPT_STEP) count(r);
    return verdict;
}

static int follows(const struct run *r) {
    for (int k = 0; k < r->parts; k++)
        if (r->part[k] == substeps_choose) return !r->control.strain_alone;
    return 0;
}

void accept_begin_repeat(struct run *r) {
    if (r->control.substeps_min <= r->substeps || follows(r)) return;
    const int may_refine = r->scene->solid->refinement != NULL; /* which may need the larger number from here on */
    if (!r->control.substeps_usual && !may_refine) r->control.substeps_usual = r->substeps;
    r->substeps = r->control.substeps_min;
}

void accept_end_step(struct run *r) {
    r->control.repeated += r->control.repeats;
    if (r->control.substeps_usual) r->substeps = r->control.substeps_usual;
    r->control.substeps_usual = 0;
    r->control.repeats = r->control.substeps_min = 0;
    r->control.dt_max = INFINITY;
}
