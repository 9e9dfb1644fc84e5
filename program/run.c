/* frana run: steps through the stages, writes samples, fields and checkpoints, and handles every end of a run. */
#include "program/run.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/signals.h"
#include "base/threads.h"
#include "base/step_status.h"
#include "coupling/control/blocked.h"
#include "coupling/march.h"
#include "coupling/interface/outside.h"
#include "coupling/control/overstep.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "coupling/control/timescale.h"
#include "cracks/cracks.h"
#include "base/files/aside.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "program/output/checkpoint.h"
#include "program/output/outputs.h"
#include "program/output/record.h"
#include "program/check/speed.h"
#include "program/output/timeline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reynolds number with the root of the permeability from which inertia is said to count. */
#define INERTIA 0.1

/* Seconds of steps from which a finished run is kept as a measurement of this machine's speed. */
#define LEARNT 20

struct program {
    const struct command *command;
    const struct scene *scene;
    struct run *run;
    struct outputs *outputs;
    struct march *march;
    struct timeline *timeline;
    enum signals_reason reason; /* to stop after the present step */
    struct steady_found found;  /* at the last window's end of a stage that waits for a quantity */
    long checked;               /* last step with a checkpoint, -1: none */
    int limit_said;             /* 1: the log has said when the batch system ends the run */
    double slowest_step, checkpoint_seconds;
};

static int due(long every, long step) { return every > 0 && step % every == 0; }

static void write_resolved(const struct program *p) {
    char path[FOLDER_PATH];
    struct aside a;
    if (par_rank() != 0) return;
    aside_begin(&a, folder_path(path, p->command->out, "scene.resolved.yaml"));
    fputs(p->scene->resolved, a.file);
    aside_end(&a);
}

static void checkpoint(struct program *p) {
    if (p->checked == p->run->step) return;
    const double start = par_seconds();
    clock_begin(CLOCK_CHECKPOINT);
    outputs_flush(p->outputs, p->run);
    checkpoint_write(p->run, p->command->out);
    record_write(p->run, p->timeline, p->command->out, "running", 0);
    clock_end(CLOCK_CHECKPOINT);
    p->checked = p->run->step;
    p->checkpoint_seconds = par_max(par_seconds() - start);
}

static void progress(struct program *p) {
    const struct scene_stage *stage = &p->scene->stage[p->run->stage];
    const struct series_sample *s = outputs_last(p->outputs);
    const long every = p->scene->output.log_every;
    if (p->run->needs.immersed && p->run->needs.bonds)
        log_progress(stage->name, p->run->stage_step, stage->steps, every, "t %.4g s  dp %.4g Pa  broken %.0f",
                     p->run->t, s->dp, s->bonds_broken);
    else if (p->run->needs.immersed)
        log_progress(stage->name, p->run->stage_step, stage->steps, every, "t %.4g s  dp %.4g Pa", p->run->t, s->dp);
    else if (p->run->needs.fluid)
        log_progress(stage->name, p->run->stage_step, stage->steps, every, "t %.4g s  u %.4g m/s  div %.1e 1/s",
                     p->run->t, s->u_bulk, s->div_max);
    else
        log_progress(stage->name, p->run->stage_step, stage->steps, every, "t %.4g s  broken %.0f", p->run->t,
                     s->bonds_broken);
}

/* Ends an unstable run: reports the position, the value and the stable step, writes the last good state, returns exit
 * code 3. status: this rank's. */
static int unstable(struct program *p, struct step_status *status) {
    const struct march_loss loss = march_give_up(p->march, status);
    if (loss.step >= 0) outputs_flush(p->outputs, p->run);
    if (loss.step >= 0 && loss.step != p->checked) checkpoint_write(p->run, p->command->out);
    log_line("%s; %s", loss.what, loss.why);
    if (par_rank() == 0) fprintf(stderr, "frana: %s; %s\n", loss.what, loss.why);
    if (loss.step >= 0) log_line("the last good state is that of step %ld: its checkpoint can be resumed", loss.step);
    record_write(p->run, p->timeline, p->command->out, "unstable", EXIT_CODE_UNSTABLE);
    return EXIT_CODE_UNSTABLE;
}

static int stopped(struct program *p) {
    struct step_status status;
    double failed = step_check(p->run, 1, &status);
    signals_stop_also(0, &failed, 1);
    if (failed > 0) return unstable(p, &status);
    checkpoint(p);
    log_line("stopped by %s after step %ld, with a checkpoint: run again with --resume", signals_name(p->reason),
             p->run->step);
    record_write(p->run, p->timeline, p->command->out, "stopped", EXIT_CODE_REQUEUE);
    return EXIT_CODE_REQUEUE;
}

/* Says once how long the batch system lets the run go on; its answer may arrive some steps after it was asked. */
static void say_limit(struct program *p) {
    if (p->limit_said) return;
    const double left = signals_batch_left();
    p->limit_said = isfinite(left);
    if (p->limit_said) log_line("the batch system ends this job in %.4g min", left / 60);
}

static void prepare_sample(void *program) {
    const struct program *p = program;
    outputs_prepare(p->outputs, p->run);
}

/* The step's one reduction also says whether to stop. */
static void largest(void *program, double *number, int n) {
    struct program *p = program;
    p->reason = signals_stop_also(2 * p->slowest_step + 1.5 * p->checkpoint_seconds, number, n);
}

/* Says what the direction of the medium is, or why no permeability is measured. */
static void say_direction(const struct run *r) {
    const double *e = r->measured.along;
    if (!r->medium) return;
    if (r->measured.why[0])
        log_line("permeability is not measured: %s", r->measured.why);
    else if (e[0] == 0 || e[1] == 0 || e[2] == 0 ? (e[0] != 0) + (e[1] != 0) + (e[2] != 0) > 1 : 1)
        log_line("permeability is measured along (%g, %g, %g)", e[0], e[1], e[2]);
    else
        log_line("permeability is measured along %c", "xyz"[medium_axis(r->medium)]);
}

/* At a stage's end: what the last sample's permeability is worth. */
static void say_flow(const struct program *p) {
    const struct run *r = p->run;
    const struct series_sample *s = outputs_last(p->outputs);
    const char *name = p->scene->stage[r->stage].name;
    if (!r->needs.immersed || r->measured.why[0] || p->scene->output.series_every == 0) return;
    if (s->porosity_effective == 0)
        log_line("stage %s: no permeability: no way through the medium along %c that cells resolve", name,
                 "xyz"[medium_axis(r->medium)]);
    else if (s->reynolds_k > INERTIA)
        log_line(
            "stage %s: the Reynolds number with the root of the permeability is %.3g, above %g: inertia counts, and "
            "the permeability is an apparent one",
            name, s->reynolds_k, INERTIA);
}

/* Looks whether the stage ends with the step just taken: it is full, or steady. */
static int look(struct program *p, int full) {
    struct run *r = p->run;
    const struct scene_stage *stage = &p->scene->stage[r->stage];
    struct steady_found *found = &p->found;
    const int steady = steady_is_due(r, r->stage_step) && steady_look(r, found);
    if (steady)
        log_line("stage %s: steady after %ld steps, t = %.6g s: permeability %.6g m2, spread %.2g of it over %d steps, "
                 "%.2g left",
                 stage->name, r->stage_step, r->t, found->value, found->spread, stage->until_window, found->left);
    else if (full && stage->has_until)
        log_line("stage %s: not steady after all its %ld steps, t = %.6g s: permeability %.6g m2, spread %.2g of it "
                 "over %d steps, %.2g left",
                 stage->name, r->stage_step, r->t, found->value, found->spread, stage->until_window, found->left);
    return full || steady;
}

/* Takes one step and writes the output that is due after it. A state that is kept or written was tested as a whole.
 * Returns an exit code to end with, or -1. */
static int step(struct program *p) {
    struct run *r = p->run;
    const struct scene_output *out = &p->scene->output;
    const long now = r->step + 1;
    const int full = r->stage_step + 1 == p->scene->stage[r->stage].steps;
    const int may_end = full || steady_may_end(r, r->stage_step + 1);
    const int saved = due(out->checkpoint_every, now);
    int sampled = due(out->series_every, now) || (may_end && out->series_every > 0);
    int drawn = due(out->fields_every, now) || (may_end && out->fields_every > 0);
    const struct march_caller caller = {.with = p, .before = sampled ? prepare_sample : NULL, .largest = largest};
    const double start = par_seconds();
    struct step_status status;
    if (!march_step(p->march, sampled || drawn || saved || may_end, &caller, &status)) return unstable(p, &status);
    const int last = look(p, full);
    sampled = due(out->series_every, now) || (last && out->series_every > 0);
    drawn = due(out->fields_every, now) || (last && out->fields_every > 0);
    outputs_sample(p->outputs, r, sampled, drawn, last);
    march_settle(p->march);
    p->slowest_step = fmax(p->slowest_step, par_seconds() - start);
    clock_begin(CLOCK_LOG);
    say_limit(p);
    progress(p);
    if (last) say_flow(p);
    clock_end(CLOCK_LOG);
    clock_begin(CLOCK_CHECKPOINT);
    if (last)
        checkpoint_write_stage(r, p->command->out); /* before the step's checkpoint, from which a resumed run
                                                     * continues */
    if (saved) checkpoint(p);
    if (saved) march_begin(p->march); /* steps are repeated from the state of which a resumed run repeats them */
    clock_end(CLOCK_CHECKPOINT);
    return p->reason != SIGNALS_NONE ? stopped(p) : -1;
}

/* Before an automatic stage the step is known only where the stage before it has left one. */
static void say_steps(const struct run *r, const struct scene_stage *stage) {
    const int automatic = r->fluid && stage->time_step <= 0;
    char length[64] = "";
    if (r->dt > 0) snprintf(length, sizeof length, " of %.5g s", r->dt);
    log_line("stage %s: %ld steps%s%s", stage->name, stage->steps - r->stage_step, length,
             automatic ? " (automatic)" : "");
}

static int stages(struct program *p) {
    struct run *r = p->run;
    for (;; r->stage++, r->stage_step = 0) {
        const struct scene_stage *stage = &p->scene->stage[r->stage];
        const int first = r->setup_seconds == 0;
        if (!first) timeline_span(p->timeline, stage->name, r->step);
        clock_rest(CLOCK_SETUP);
        clock_phase(CLOCK_PHASE_LIMITS);
        step_begin_stage(r);
        if (first) r->setup_seconds = par_seconds() - r->wall_start;
        if (first) timeline_span(p->timeline, stage->name, r->step);
        clock_phase(CLOCK_PHASE_STEPS);
        clock_rest(CLOCK_OTHER);
        p->found = (struct steady_found){NAN, NAN, NAN};
        if (r->stage_step < stage->steps && !steady_has_ended(r)) say_steps(r, stage);
        if (r->substeps > 0)
            log_line("stage %s: %d solid substeps of %.4g s, stable up to %.4g s", stage->name, r->substeps,
                     r->dt / r->substeps, r->solid_stable);
        march_begin(p->march);
        while (r->stage_step < stage->steps && !steady_has_ended(r)) {
            const int code = step(p);
            if (code >= 0) return code;
        }
        if (stage->crack_fluid && r->cracks->steps > 0)
            log_line("stage %s: crack fluid: %.3g solves and %.3g iterations a substep, struts made %ld times",
                     stage->name, (double)r->cracks->solves / (double)r->cracks->steps,
                     (double)r->cracks->iterations / (double)r->cracks->steps, r->cracks->renewals);
        outputs_report(p->outputs, r);
        if (r->stage + 1 == p->scene->stages) return EXIT_CODE_DONE;
    }
}

static void refuse_to_overwrite(const struct command *c, int may) {
    if (!may && folder_has_run(c->out))
        die_all(EXIT_CODE_FILE, "%s holds a run already: --resume goes on with it, --out DIR writes elsewhere", c->out);
}

/* Dies (exit 2) on stages whose steps the solid cannot take; that is known only once its bonds exist. Returns the
 * number of sentences on given steps that are too long, OVERSTEP_MAX a stage at most, and, one a stage, on steps of so
 * many substeps that the run will hardly end. */
static int check_stages(struct run *r, char (*sentence)[TIMESCALE_SENTENCE]) {
    char longer[OVERSTEP_MAX][OVERSTEP_SENTENCE];
    int n = 0;
    for (r->stage = 0; r->stage < r->scene->stages; r->stage++) {
        const int elastic = r->solid && r->scene->stage[r->stage].solid == SCENE_SOLID_ELASTIC;
        if (elastic) step_begin_stage(r);
        for (int k = 0, found = overstep_of(r, longer); k < found; k++)
            memcpy(sentence[n++], longer[k], OVERSTEP_SENTENCE);
        if (elastic) n += timescale_of(r, sentence[n]);
    }
    r->stage = 0;
    return n;
}

static void begin(struct program *p) {
    const struct command *c = p->command;
    const int here = c->resume && !c->resume_file;
    char aside[FOLDER_PATH];
    if (c->resume) checkpoint_look(c->out, c->resume_file);
    if (here) folder_hold(c->out);
    refuse_to_overwrite(c, here || c->anew);
    signals_begin(c->max_wall);
    clock_clear();
    clock_rest(CLOCK_SETUP);
    p->timeline = timeline_new();
    par_count_clear();
    p->run = run_new(p->scene); /* all mistakes of the scene are found here at the latest, before any file is written */
    clock_phase(CLOCK_PHASE_OUTPUT);
    p->outputs = outputs_new(p->run);
    char(*too_long)[TIMESCALE_SENTENCE] = calloc((size_t)p->scene->stages * (OVERSTEP_MAX + 1), sizeof *too_long);
    clock_phase(CLOCK_PHASE_LIMITS);
    const int steps_too_long = here ? 0 : check_stages(p->run, too_long);
    clock_phase(CLOCK_PHASE_OUTPUT);
    const char *from = c->resume ? checkpoint_read(p->run, c->out, c->resume_file) : NULL; /* before a folder is made */
    if (c->anew) folder_set_aside(c->out, aside);
    folder_make(c->out);
    folder_hold(c->out);
    refuse_to_overwrite(c, here); /* the folder is locked: no other run can write there */
    log_begin(c->out, c->quiet, here);
    log_line("frana: %s", p->scene->title);
    if (c->anew) log_line("the run that was here had not reached a checkpoint: its files are in %s", aside);
    const int threads = threads_count(), cores = threads_cores();
    if (cores > 0 && cores < threads)
        log_line("warning: %d threads of a rank share %d core%s: mpiexec --map-by slot:pe=%d gives them as many",
                 threads, cores, cores > 1 ? "s" : "", threads);
    if (c->resume) {
        log_line("resumed from %s", from);
        p->checked = p->run->resumed = p->run->step;
        log_line("resumed at step %ld, t = %.6g s", p->run->step, p->run->t);
        if (here) p->run->wall_earlier = record_earlier(c->out, p->run->step);
    }
    write_resolved(p);
    outputs_open(p->outputs, p->run, c->out, here ? p->run->step : -1);
    p->march = march_new(p->run);
    char sentence[RECORD_LEFT_OUT][RECORD_SENTENCE];
    for (int k = 0, n = record_left_out(p->scene, sentence); k < n; k++) log_line("left out: %s", sentence[k]);
    char blocked[BLOCKED_MAX][BLOCKED_SENTENCE];
    for (int k = 0, n = blocked_of(p->run, blocked); k < n; k++) log_line("warning: %s", blocked[k]);
    char outside[OUTSIDE_SENTENCE];
    for (int b = 0; p->run->solid && b < p->run->solid->in.bodies; b++)
        if (outside_of(p->run->solid, b, p->run->fluid != NULL, outside)) log_line("warning: %s", outside);
    say_direction(p->run);
    for (int k = 0; k < steps_too_long; k++) log_line("warning: %s", too_long[k]);
    free(too_long);
}

int program_run(const struct command *c, const struct scene *scene) {
    struct program p = {.command = c, .scene = scene, .checked = -1};
    begin(&p);
    const int code = stages(&p);
    if (code == EXIT_CODE_DONE) {
        timeline_span(p.timeline, "end", p.run->step);
        if (scene->output.checkpoint_every > 0) checkpoint(&p);
        record_write(p.run, p.timeline, c->out, "done", code);
        const struct speed_work work = speed_worked(p.run);
        speed_learn(p.run, &work, LEARNT);
        log_line("done: %ld steps in %.1f s", p.run->step, par_seconds() - p.run->wall_start);
    }
    march_free(p.march);
    timeline_free(p.timeline);
    outputs_free(p.outputs);
    run_free(p.run);
    log_end();
    folder_hold_release();
    return code;
}
