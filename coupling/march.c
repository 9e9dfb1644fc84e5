/* Takes steps: takes a step, decides whether it is accepted, and repeats a rejected one from a saved state. */
#include "coupling/march.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "coupling/control/accept.h"
#include "coupling/control/explain.h"
#include "coupling/control/rollback.h"
#include "coupling/control/probe_watch.h"
#include "coupling/control/unresolved.h"
#include "coupling/load/reaction.h"
#include "coupling/run.h"
#include "coupling/stage.h"
#include "coupling/step.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Number of steps between tests of the whole fluid for values beyond reason, and between the states saved for the case
 * of an unstable run. */
enum { CHECK_EVERY = 10, SAVE_EVERY = 50 };

struct march {
    struct run *run;           /* borrowed */
    struct rollback *rollback; /* the last good state */
};

struct march *march_new(struct run *r) {
    struct march *m = calloc(1, sizeof *m);
    ENSURE(m, "no memory for %zu bytes", sizeof *m);
    m->run = r;
    m->rollback = rollback_new(r);
    return m;
}

void march_free(struct march *m) {
    if (!m) return;
    rollback_free(m->rollback);
    free(m);
}

void march_begin(struct march *m) { rollback_save(m->rollback, m->run); }

/* Goes back to the state before the last step: restores the last saved state, and repeats the steps from there. Returns
 * whether that was possible. */
static int go_back(struct march *m) {
    struct run *r = m->run;
    struct step_control *a = &r->control;
    const long before = r->step - 1, saved = rollback_restore(m->rollback, r);
    const double most = a->dt_max;
    const int least = a->substeps_min, tries = a->repeats;
    if (saved < 0) return 0;
    a->dt_max = INFINITY;
    a->substeps_min = 0;
    for (a->replays = 1; r->step < before;) {
        struct step_status status = {0};
        double number[ACCEPT_NUMBERS];
        if (!step_advance(r)) return 0;
        clock_begin(CLOCK_JUDGING);
        accept_numbers(r, 0, number);
        par_max_array(number, ACCEPT_NUMBERS);
        accept_step(r, number, &status);
        clock_end(CLOCK_JUDGING);
    }
    a->replays = 0;
    if (r->step > saved) rollback_save(m->rollback, r);
    a->dt_max = most;
    a->substeps_min = least;
    a->repeats = tries;
    return 1;
}

static int is_due(long every, long step) { return step % every == 0; }

/* The state is saved after each step that may take minutes, so that an interrupted step loses no other. */
static int is_long(const struct run *r) {
    return run_stage(r)->relax || (r->solid && r->substeps >= SOLID_INTEGRATE_MANY);
}

enum march_end march_step(struct march *m, int all_fields, const struct march_caller *caller,
                          struct step_status *status) {
    struct run *r = m->run;
    const long now = r->step + 1;
    all_fields = all_fields || is_due(CHECK_EVERY, now) || is_due(SAVE_EVERY, now);
    for (;;) {
        double number[ACCEPT_NUMBERS];
        if (caller->before) caller->before(caller->with);
        if (!step_advance(r)) return MARCH_INTERRUPTED;
        clock_begin(CLOCK_JUDGING);
        accept_numbers(r, step_check(r, all_fields, status), number);
        if (caller->largest)
            caller->largest(caller->with, number, ACCEPT_NUMBERS);
        else
            par_max_array(number, ACCEPT_NUMBERS);
        const enum accept_verdict verdict = accept_step(r, number, status);
        clock_end(CLOCK_JUDGING);
        switch (verdict) {
        case ACCEPT_STEP:
            return MARCH_DONE;
        case ACCEPT_ABORT:
            return MARCH_FAILED;
        case ACCEPT_REPEAT:
            if (!go_back(m)) return r->solid && r->solid->stops ? MARCH_INTERRUPTED : MARCH_FAILED;
            accept_begin_repeat(r);
        }
    }
}

int march_save_state(struct march *m, struct step_status *status) {
    struct run *r = m->run;
    const int fits = rollback_fits(m->rollback, r), was_repeated = r->control.repeats > 0;
    accept_end_step(r);
    if (!fits) {
        rollback_free(m->rollback);
        m->rollback = rollback_new(r);
    }
    const int ends = stage_has_ended(r), is_due_now = is_due(SAVE_EVERY, r->step) || is_long(r);
    watch_note(r);
    reaction_watch_note(r);
    probe_watch_note(r);
    probe_energy_note(r);
    if (is_due_now || ends) reaction_watch_check(r);
    if (is_due_now || ends) probe_watch_check(r, ends);
    if ((is_due_now || ends) &&
        (watch_check(r, status) || probe_energy_check(r, status) || unresolved_check(r, ends, status)))
        return 0;
    if (is_due_now || !fits || was_repeated) rollback_save(m->rollback, r);
    return 1;
}

/* What was found, in words. */
static void describe(const struct run *r, const struct step_status *status, char *text, size_t size) {
    if (status->seen_in == STEP_STATUS_BALANCE)
        snprintf(
            text, size,
            "the energy balance is broken in step %ld: %.3g J have come from nothing, %.3g J were exchanged; probably "
            "by %s",
            r->step, status->value, r->watch.exchanged, watch_cause(r));
    else if (status->seen_in == STEP_STATUS_UNRESOLVED)
        snprintf(text, size,
                 "the flow has become too fast for its cells by step %ld: the Reynolds number of a cell, %s, is %.3g",
                 r->step, status->field, status->value);
    else if (status->seen_in == STEP_STATUS_PROBES)
        snprintf(text, size,
                 "the energy balance is broken in step %ld: by probes the fluid has got %.3g J more than the solid has "
                 "lost; %.3g J were exchanged. damping_relative (see frana check) or coupling.load: reaction helps",
                 r->step, status->value, r->watch.made.exchanged);
    else
        snprintf(text, size, "unstable in step %ld: %s = %g at (%.6g, %.6g, %.6g) m on rank %d", r->step, status->field,
                 status->value, status->x[0], status->x[1], status->x[2], status->rank);
}

long march_interrupt(struct march *m) {
    struct run *r = m->run;
    const int relaxes = run_stage(r)->relax && run_stage(r)->increment == 0;
    accept_end_step(r);
    return relaxes ? r->step : rollback_restore(m->rollback, r);
}

struct march_failure march_abort(struct march *m, struct step_status *status) {
    struct run *r = m->run;
    const double dt = r->dt;
    const int substeps = r->substeps;
    struct march_failure loss = {.why = "the solid has been refined since a state was kept"};
    step_status_agree(status);
    accept_end_step(r);
    describe(r, status, loss.what, sizeof loss.what);
    loss.step = rollback_restore(m->rollback, r);
    if (status->seen_in == STEP_STATUS_UNRESOLVED)
        unresolved_explain(r, status->value, loss.why, sizeof loss.why);
    else if (loss.step >= 0)
        explain_abort(r, dt, substeps, loss.why, sizeof loss.why);
    return loss;
}
