/* frana run: steps through the stages, writes what is due after a step, and handles every end of a run. */
#include "program/run/run.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/signals.h"
#include "base/step_status.h"
#include "coupling/march.h"
#include "coupling/control/overstep.h"
#include "coupling/control/duration.h"
#include "coupling/run.h"
#include "coupling/stage.h"
#include "coupling/step.h"
#include "coupling/control/timescale.h"
#include "coupling/control/braked.h"
#include "coupling/control/undamped.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "program/output/checkpoint.h"
#include "program/output/outputs.h"
#include "program/output/run_json.h"
#include "program/check/speed.h"
#include "program/output/timeline.h"
#include "program/run/changes.h"
#include "program/run/report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Seconds of steps from which a finished run is stored as a measurement of this machine's speed. */
#define MEASURED_MIN 20

struct program {
    const struct command *command;
    const struct scene *scene;
    struct run *run;
    struct outputs *outputs;
    struct march *march;
    struct timeline *timeline;
    enum signals_reason reason;      /* to stop after the present step */
    struct early_breakage_load load; /* of the series' samples */
    struct steady_found steady;      /* at the last window's end of a stage that waits for a quantity */
    long last_checkpoint;            /* its step, -1: none */
    int limit_logged;                /* 1: the log says when the batch system ends the run */
    double slowest_step, checkpoint_seconds;
};

/* Whether what is written every so many steps is due after this one; 0: never. */
static int is_due(long every, long step, int stage_ends) { return every > 0 && (step % every == 0 || stage_ends); }

static void write_resolved(const struct program *p) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    if (par_rank() != 0) return;
    atomic_write_begin(&a, folder_path(path, p->command->out, "scene.resolved.yaml"));
    fputs(p->scene->resolved, a.file);
    atomic_write_end(&a);
}

static void checkpoint(struct program *p) {
    if (p->last_checkpoint == p->run->step) return;
    const double start = par_seconds();
    clock_begin(CLOCK_CHECKPOINT);
    outputs_flush(p->outputs, p->run);
    checkpoint_write(p->run, p->command->out);
    run_json_write(p->run, p->timeline, p->command->out, "running", 0);
    clock_end(CLOCK_CHECKPOINT);
    p->last_checkpoint = p->run->step;
    p->checkpoint_seconds = par_max(par_seconds() - start);
    signals_hold_back(1.5 * p->checkpoint_seconds);
}

/* The stage's checkpoint before the step's, from which a resumed run continues. After the latter steps are repeated
 * from the state from which a resumed run repeats them. */
static void write_checkpoints(struct program *p, int stage_ends, int is_due) {
    clock_begin(CLOCK_CHECKPOINT);
    if (stage_ends) checkpoint_write_stage(p->run, p->command->out);
    if (is_due) checkpoint(p);
    if (is_due) march_begin(p->march);
    clock_end(CLOCK_CHECKPOINT);
}

/* Ends an unstable run: reports the position, the value and the stable step, writes the last good state, returns exit
 * code 3. status: this rank's. */
static int end_unstable(struct program *p, struct step_status *status) {
    const struct march_failure loss = march_abort(p->march, status);
    if (loss.step >= 0) outputs_flush(p->outputs, p->run);
    if (loss.step >= 0 && loss.step != p->last_checkpoint) checkpoint_write(p->run, p->command->out);
    log_line("%s; %s", loss.what, loss.why);
    if (par_rank() == 0) fprintf(stderr, "frana: %s; %s\n", loss.what, loss.why);
    if (loss.step >= 0) log_line("the last good state is that of step %ld: its checkpoint can be resumed", loss.step);
    run_json_write(p->run, p->timeline, p->command->out, "unstable", EXIT_CODE_UNSTABLE);
    return EXIT_CODE_UNSTABLE;
}

/* How a run that was stopped goes on. */
static const char *again(const struct program *p) {
    return p->command->verb == COMMAND_RUN ? "run again with --resume" : "the same command goes on";
}

/* Ends a run that was asked to stop: with a checkpoint, if its state is sound. Returns the exit code. */
static int end_stopped(struct program *p) {
    struct step_status status;
    double failed = step_check(p->run, 1, &status);
    signals_stop_also(0, &failed, 1);
    if (failed > 0) return end_unstable(p, &status);
    checkpoint(p);
    log_line("stopped by %s after step %ld, with a checkpoint: %s", signals_name(p->reason), p->run->step, again(p));
    run_json_write(p->run, p->timeline, p->command->out, "stopped", EXIT_CODE_REQUEUE);
    return EXIT_CODE_REQUEUE;
}

/* Ends a run that was asked to stop within a long step: the step is given up, but for what a relaxation has reached.
 * Returns the exit code. */
static int end_given_up(struct program *p) {
    struct run *r = p->run;
    const char *why = signals_name(r->solid->stops);
    const long given_up = r->step + 1, step = march_interrupt(p->march);
    r->solid->stops = SIGNALS_NONE;
    if (step == given_up - 1) p->last_checkpoint = -1; /* a relaxation has moved the solid since */
    if (step >= 0) checkpoint(p);
    if (p->last_checkpoint >= 0)
        log_line("stopped by %s within step %ld, with a checkpoint of step %ld: %s", why, given_up, p->last_checkpoint,
                 again(p));
    else
        log_line("stopped by %s within step %ld, before the first checkpoint", why, given_up);
    run_json_write(r, p->timeline, p->command->out, "stopped", EXIT_CODE_REQUEUE);
    return EXIT_CODE_REQUEUE;
}

/* Logs once how long the batch system lets the run go on; its answer may arrive some steps after the question. */
static void log_limit(struct program *p) {
    if (p->limit_logged) return;
    const double left = signals_batch_left();
    p->limit_logged = isfinite(left);
    if (p->limit_logged) log_line("the batch system ends this job in %.4g min", left / 60);
}

static void prepare_sample(void *program) {
    const struct program *p = program;
    outputs_prepare(p->outputs, p->run);
}

/* The step's one reduction also agrees on whether to stop. */
static void agree(void *program, double *number, int n) {
    struct program *p = program;
    p->reason = signals_stop_also(2 * p->slowest_step + 1.5 * p->checkpoint_seconds, number, n);
}

/* Whether the stage ends with the step just taken: with its last one, by its number or its duration, or because it is
 * steady. */
static int stage_ends(struct program *p, int is_last) {
    struct run *r = p->run;
    const int steady = steady_is_due(r, r->stage_step) && steady_sample(r, &p->steady);
    report_steadiness(r, &p->steady, steady, is_last);
    return is_last || steady;
}

/* Takes one step and writes the output that is due after it. A state that is kept or written was tested as a whole.
 * Returns an exit code to end with, or -1. */
static int step(struct program *p) {
    struct run *r = p->run;
    const struct scene_output *out = &p->scene->output;
    const long now = r->step + 1;
    const int is_last = r->stage_step + 1 == run_stage(r)->steps;
    const int may_end = is_last || duration_may_end(r) || steady_may_end(r, r->stage_step + 1);
    const int checkpoint_due = is_due(out->checkpoint_every, now, 0),
              series_may = is_due(out->series_every, now, may_end),
              fields_may = is_due(out->fields_every, now, may_end);
    const struct march_caller caller = {.with = p, .before = series_may ? prepare_sample : NULL, .largest = agree};
    const double start = par_seconds();
    struct step_status status;
    switch (march_step(p->march, series_may || fields_may || checkpoint_due || may_end, &caller, &status)) {
    case MARCH_FAILED:
        return end_unstable(p, &status);
    case MARCH_INTERRUPTED:
        return end_given_up(p);
    case MARCH_DONE:
        break;
    }
    const int ends = stage_ends(p, is_last || duration_is_over(r));
    outputs_sample(p->outputs, r, is_due(out->series_every, now, ends), is_due(out->fields_every, now, ends), ends);
    if (p->reason == SIGNALS_NONE) p->reason = outputs_stopped(p->outputs);
    if (r->needs.immersed && is_due(out->series_every, now, 0)) early_breakage_load_add(&p->load, r->t, r->load);
    if (!march_save_state(p->march, &status)) return end_unstable(p, &status);
    p->slowest_step = fmax(p->slowest_step, par_seconds() - start);
    clock_begin(CLOCK_LOG);
    log_limit(p);
    report_progress(r, outputs_last(p->outputs));
    if (ends) report_flow(r, outputs_last(p->outputs));
    clock_end(CLOCK_LOG);
    write_checkpoints(p, ends, checkpoint_due);
    return p->reason != SIGNALS_NONE ? end_stopped(p) : -1;
}

/* For signals_at_once. */
static int in_set_up(const struct program *p) { return p->command->verb == COMMAND_RUN ? 1 : 3; }

/* Chooses the stage's parts and steps; before the first stage the set-up ends with this. */
static void begin_stage(struct program *p) {
    struct run *r = p->run;
    const struct scene_stage *stage = &p->scene->stage[r->stage];
    const int is_first = r->setup_seconds == 0;
    signals_at_once(in_set_up(p)); /* the stage before has left a checkpoint */
    if (!is_first) timeline_span(p->timeline, stage->name, r->step);
    clock_default(CLOCK_SETUP);
    clock_phase(CLOCK_PHASE_LIMITS);
    step_begin_stage(r);
    if (is_first) r->setup_seconds = par_seconds() - r->wall_start;
    if (is_first) timeline_span(p->timeline, stage->name, r->step);
    clock_phase(CLOCK_PHASE_STEPS);
    clock_default(CLOCK_OTHER);
    p->steady = steady_nothing();
    report_stage(r);
    report_early_breakage(r, &p->load);
    watch_begin(r);
    march_begin(p->march);
    if (r->stage > 0) run_json_write(r, p->timeline, p->command->out, "running", 0); /* where the stage began */
    signals_at_once(0);
}

/* Returns the exit code. */
static int run_stages(struct program *p) {
    struct run *r = p->run;
    for (;; r->stage++, r->stage_step = 0) {
        begin_stage(p);
        while (!stage_has_ended(r)) {
            const int code = step(p);
            if (code >= 0) return code;
        }
        watch_report(r);
        report_duration(r);
        report_strength(r);
        report_leaving(r);
        report_ramp_of_stage(r);
        report_crack_fluid(r);
        outputs_report(p->outputs, r);
        if (r->stage + 1 == p->scene->stages) return EXIT_CODE_DONE;
    }
}

static void refuse_to_overwrite(const struct command *c, int may) {
    if (!may && folder_has_run(c->out))
        die_all(EXIT_CODE_FILE, "%s holds a run already: --resume goes on with it, --out DIR writes elsewhere", c->out);
}

/* Dies (exit 2) on stages whose steps the solid cannot take; that is known only once its bonds exist. Returns the
 * number of sentences on given steps that are too long, OVERSTEP_MAX a stage at most, and, one a stage each, on steps
 * of so many substeps that the run will hardly end, on loads by probes without damping and on bodies that are braked.
 */
_Static_assert((int)UNDAMPED_SENTENCE <= (int)TIMESCALE_SENTENCE, "a sentence has room");
_Static_assert((int)BRAKED_SENTENCE <= (int)TIMESCALE_SENTENCE, "a sentence has room");
static int check_stages(struct run *r, char (*sentence)[TIMESCALE_SENTENCE]) {
    char longer[OVERSTEP_MAX][OVERSTEP_SENTENCE];
    int n = 0;
    for (r->stage = 0; r->stage < r->scene->stages; r->stage++) {
        const int elastic = r->solid && r->scene->stage[r->stage].solid == SCENE_SOLID_ELASTIC;
        if (elastic) step_begin_stage(r);
        for (int k = 0, found = overstep_of(r, longer); k < found; k++)
            memcpy(sentence[n++], longer[k], OVERSTEP_SENTENCE);
        if (elastic) n += timescale_of(r, sentence[n]);
        if (elastic) n += undamped_of(r, sentence[n]);
        if (elastic) n += braked_of(r, sentence[n]);
    }
    r->stage = 0;
    return n;
}

/* Makes the run. All mistakes of the scene are found here at the latest, before any file is written. */
static void make_run(struct program *p) {
    signals_begin(p->command->max_wall);
    signals_at_once(in_set_up(p));
    clock_clear();
    clock_default(CLOCK_SETUP);
    p->timeline = timeline_new();
    par_count_clear();
    p->run = run_new(p->scene);
    clock_phase(CLOCK_PHASE_OUTPUT);
    p->outputs = outputs_new(p->run);
}

/* Makes and locks the run folder, and begins or continues its log. from: the checkpoint that was read, or NULL. */
static void open_folder(struct program *p, const char *from, int continues) {
    const struct command *c = p->command;
    char unfinished[FOLDER_PATH];
    if (c->archives) folder_archive(c->out, unfinished);
    folder_make(c->out);
    folder_hold(c->out);
    refuse_to_overwrite(c, continues); /* the folder is locked: no other run can write there */
    log_begin(c->out, c->quiet, continues);
    log_line("frana: %s", p->scene->title);
    if (c->archives) log_line("the run that was here had not reached a checkpoint: its files are in %s", unfinished);
    report_threads();
    if (!from) return;
    log_line("resumed from %s", from);
    p->last_checkpoint = p->run->resumed = p->run->step;
    log_line("resumed at step %ld, t = %.6g s", p->run->step, p->run->t);
    if (continues) p->run->wall_earlier = run_json_earlier_seconds(c->out, p->run->step);
}

static void begin(struct program *p) {
    const struct command *c = p->command;
    const int continues = c->resume && !c->resume_file; /* the run of this folder */
    if (c->resume) checkpoint_require(c->out, c->resume_file);
    if (continues) folder_hold(c->out);
    refuse_to_overwrite(c, continues || c->archives);
    make_run(p);
    char(*too_long)[TIMESCALE_SENTENCE] = calloc((size_t)p->scene->stages * (OVERSTEP_MAX + 3), sizeof *too_long);
    clock_phase(CLOCK_PHASE_LIMITS);
    const int steps_too_long = continues ? 0 : check_stages(p->run, too_long);
    clock_phase(CLOCK_PHASE_OUTPUT);
    const char *from = c->resume ? checkpoint_read(p->run, c->out, c->resume_file) : NULL; /* before a folder is made */
    open_folder(p, from, continues);
    if (from) changes_log(from, p->scene);
    if (!continues) write_resolved(p); /* first, as it says whose the tables are if the run is killed here */
    outputs_open(p->outputs, p->run, c->out, continues ? p->run->step : -1); /* may refuse a table of another scene */
    if (continues) write_resolved(p);
    p->march = march_new(p->run);
    report_set_up(p->run);
    for (int k = 0; k < steps_too_long; k++) log_line("warning: %s", too_long[k]);
    free(too_long);
}

static void finish(struct program *p) {
    timeline_span(p->timeline, "end", p->run->step);
    if (p->scene->output.checkpoint_every > 0) checkpoint(p);
    run_json_write(p->run, p->timeline, p->command->out, "done", EXIT_CODE_DONE);
    const struct speed_work work = speed_work_done(p->run);
    speed_store_work(p->run, &work, MEASURED_MIN);
    report_ramp(p->run, 1);
    log_line("done: %ld steps in %.1f s", p->run->step, par_seconds() - p->run->wall_start);
}

int program_run(const struct command *c, const struct scene *scene) {
    struct program p = {.command = c, .scene = scene, .last_checkpoint = -1};
    begin(&p);
    const int code = run_stages(&p);
    if (code == EXIT_CODE_DONE) finish(&p);
    march_free(p.march);
    timeline_free(p.timeline);
    outputs_free(p.outputs);
    run_free(p.run);
    log_end();
    folder_hold_release();
    return code;
}
