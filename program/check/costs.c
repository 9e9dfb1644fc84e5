/* Forecasts steps, sweeps, bytes of the files and the time of a run; measures some steps if it is asked to. */
#include "program/check/costs.h"
#include "base/clock.h"
#include "base/par.h"
#include "base/print.h"
#include "base/step_status.h"
#include "coupling/march.h"
#include "coupling/stage.h"
#include "coupling/step.h"
#include "coupling/control/time_step.h"
#include "coupling/control/timescale.h"
#include "program/output/checkpoint.h"
#include "program/output/amount.h"
#include "program/output/outputs.h"
#include "program/check/parts.h"
#include "program/check/speed.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>
#include <time.h>

enum { BRIEF = 64 };
/* --measure: seconds of steps in all, steps of a stage at most; seconds from which the result is stored. */
static const double BUDGET = 10, STORED_MIN = 0.2;
enum { STEPS_MAX = 200 };
static const double MONTH = 30 * 86400.0;

static const char *duration(double s, char text[BRIEF]) {
    static const struct {
        double most, unit;
        const char *name;
    } in[] = {{100, 1, "s"},
              {100 * 60, 60, "min"},
              {48 * 3600, 3600, "h"},
              {730 * 86400.0, 86400, "days"},
              {INFINITY, 365.25 * 86400, "years"}};
    int k = 0;
    while (k < 4 && s >= in[k].most) k++;
    snprintf(text, BRIEF, "%.2g %s", s / in[k].unit, in[k].name);
    if (s / in[k].unit >= 100) snprintf(text, BRIEF, "%.0f %s", s / in[k].unit, in[k].name);
    return text;
}

static const char *bytes(double n, char text[BRIEF]) {
    static const char *const name[] = {"kB", "MB", "GB", "TB", "PB"};
    int k = 0;
    for (n *= 1e-3; k < 4 && n >= 999.5; k++) n *= 1e-3;
    snprintf(text, BRIEF, n >= 99.5 ? "%.0f %s" : "%.2g %s", n, name[k]);
    return text;
}

/* The step of the present stage as far as it is known before a run, s; INFINITY: only the run knows it. */
static double step_of(const struct run *r) {
    const struct scene_stage *stage = run_stage(r);
    return stage->relax ? fmax(stage->increment, fmax(stage->time_step, 0))
           : r->dt > 0  ? r->dt
           : r->fluid   ? fmin(stage->cfl * fluid_limits_foreseen(r->fluid).step, time_step_first(r))
                        : 0;
}

double costs_stage_steps(const struct run *r) {
    const struct scene_stage *stage = run_stage(r);
    const double step = step_of(r), most = (double)stage->steps;
    return stage->duration > 0 && step > 0 && isfinite(step) ? fmin(most, ceil(stage->duration / step * (1 - 1e-9)))
                                                             : most;
}

void costs_add(struct costs *c, struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const double most = 1e9;
    const double steps = costs_stage_steps(r);
    c->at_most |= stage->has_until || stage->duration > 0;
    c->relaxes |= stage->relax;
    if (!c->moves && stage->solid == SCENE_SOLID_ELASTIC) {
        c->moves = 1;
        c->moves_from = c->seconds;
    }
    c->steps += steps;
    c->seconds += stage->duration > 0 ? fmin(stage->duration, steps * step_of(r)) : steps * step_of(r);
    if (stage->relax) return;
    const double substeps = timescale_substeps(r);
    if (!(substeps > 0)) return;
    c->substeps += steps * substeps;
    c->sweeps += steps * (double)solid_integrate_sweeps(r->solid, (int)fmin(substeps, most));
    if (c->warnings < COSTS_WARNINGS) c->warnings += timescale_of(r, c->warning[c->warnings]);
}

static void print_steps(const struct run *r, const struct costs *n) {
    print("  %-10s %.0f%s", "steps", n->steps, n->at_most ? " at most" : "");
    if (n->sweeps > 0)
        print(", %.4g substeps of the solid, %.4g sweeps over %.0f directed bonds%s", n->substeps, n->sweeps,
              (double)run_directed_bonds(r), r->solid->dilatation ? ", in two passes by poisson_ratio" : "");
    if (n->relaxes) print("; relaxations, of which the number of steps is not known, are not counted");
    print("\n");
}

/* Bytes that are free where the folder is or will be; negative: not known. */
static double free_bytes(const char *folder, char place[512]) {
    struct statvfs is;
    snprintf(place, 512, "%s", folder);
    while (statvfs(place, &is) != 0) {
        char *slash = strrchr(place, '/');
        if (slash == place || !*place || !strcmp(place, ".")) return -1;
        if (slash)
            *slash = '\0';
        else
            snprintf(place, 512, ".");
    }
    return (double)is.f_bavail * (double)is.f_frsize;
}

/* The most that fragments.csv and events.csv can hold: each particle is a piece of its own in the lists at the start
 * and at each dump, and comes off once; each bond is an event of its own. */
static void print_broken(const struct run *r) {
    enum { LONGEST = 23 }; /* bytes of a number and its comma: -1.23456789012345e-123 */
    const struct scene_output *o = &r->scene->output;
    if (!r->needs.breakage) return;
    const double particles = (double)r->solid->n_global;
    const double lists = o->fields_every > 0 ? (double)amount_fields(r) : r->scene->stages;
    const int dim = r->scene->dimension, fragments = o->fragments && o->series_every > 0;
    char text[BRIEF];
    if (!fragments && !o->events) return;
    print("  %-10s and, if all of it breaks, at most", "");
    if (fragments) print(" %s of fragments.csv", bytes(LONGEST * (12 + 2.0 * dim) * particles * (2 + lists), text));
    if (o->events)
        print("%s %s of events.csv", fragments ? " and" : "",
              bytes(LONGEST * (7 + 2.0 * dim) * (double)run_directed_bonds(r) / 2, text));
    print("\n");
}

/* Two checkpoints stay while a third is written; one stays of each stage. */
static void print_disk(struct run *r, const struct outputs *outputs, const struct costs *n, const char *out) {
    enum { DIGITS = 18 };
    const struct scene_output *o = &r->scene->output;
    const long dumps = amount_fields(r);
    const double dump = amount_fields_bytes(r), checkpoint = checkpoint_bytes(r),
                 tables = DIGITS * outputs_numbers(outputs, r, (long)n->steps);
    const double times = o->checkpoint_every > 0 ? floor(n->steps / (double)o->checkpoint_every) + 1 : 0;
    const double kept = r->scene->stages + fmin(times, CHECKPOINTS_KEPT + 1);
    const double sum = (double)dumps * dump + kept * checkpoint + tables,
                 has = par_min(free_bytes(out, (char[512]){""}));
    char text[5][BRIEF];
    print("  %-10s about %s: fields %s, %.0f checkpoint%s %s, tables %s", "disk", bytes(sum, text[0]),
          bytes((double)dumps * dump, text[1]), kept, kept > 1 ? "s" : "", bytes(kept * checkpoint, text[2]),
          bytes(tables, text[3]));
    print(has >= 0 ? "; %s are free here\n" : "\n", bytes(has, text[4]));
    if (has >= 0 && sum > has)
        print("  warning: the run writes %s, and %s are free: output.fields_every or another disk\n", text[0], text[4]);
}

/* Of a stage. */
struct measured {
    double seconds; /* of a step; 0: not measured */
    double steps;   /* as far as they are known before a run */
};

/* Of each stage. Returns 0 if a step was lost. */
static int measure(struct run *r, struct measured *found) {
    const struct march_caller nobody = {0};
    struct march *m = march_new(r);
    int stages = 0, good = 1;
    for (int k = 0; k < r->scene->stages; k++) stages += !r->scene->stage[k].relax && r->scene->stage[k].steps > 0;
    r->wall_start = par_seconds();
    r->setup_seconds = 0;
    r->fluid_cell_steps = r->solid_sweeps = 0;
    clock_clear();
    for (r->stage = 0; good && r->stage < r->scene->stages; r->stage++, r->stage_step = 0) {
        const struct scene_stage *stage = &r->scene->stage[r->stage];
        if (stage->relax) continue;
        step_begin_stage(r);
        watch_begin(r);
        march_begin(m);
        double start = par_seconds(), first = 0;
        int n = 0;
        found[r->stage].steps = costs_stage_steps(r);
        while (good && !stage_has_ended(r) && n < STEPS_MAX) {
            struct step_status status;
            good = march_step(m, 0, &nobody, &status);
            if (!good) {
                const struct march_failure loss = march_abort(m, &status);
                print(
                    "  warning: stage %s, measured after only a few steps of the stages before it, is unstable in its "
                    "step %d: %s; %s\n",
                    stage->name, n + 1, loss.what, loss.why);
                break;
            }
            if (!march_save_state(m, &status)) break;
            const double passed = par_max(par_seconds() - start);
            if (n++ == 0) first = passed; /* its arrays are touched for the first time */
            found[r->stage].seconds = n > 1 ? (passed - first) / (n - 1) : passed;
            if (n > 1 && passed > BUDGET / stages) break;
        }
    }
    if (good) {
        const struct speed_work work = speed_work_done(r);
        speed_store_work(r, &work, STORED_MIN);
    }
    march_free(m);
    r->stage = 0;
    return good;
}

/* Returns the run's seconds; negative: a step was lost. */
static double print_measured(struct run *r) {
    struct measured *found = calloc((size_t)r->scene->stages, sizeof *found);
    double sum = 0;
    char text[BRIEF];
    const int good = found && measure(r, found);
    if (good) {
        print("  %-10s", "time");
        for (int k = 0, n = 0; k < r->scene->stages; k++) {
            const double its = found[k].seconds * found[k].steps;
            sum += its;
            if (its > 0)
                print("%s %s %s (%.3g s a step)", n++ ? "," : "", r->scene->stage[k].name, duration(its, text),
                      found[k].seconds);
        }
        print("; in all about %s on %d rank%s, without output, measured now\n", duration(sum, text), par_size(),
              par_size() > 1 ? "s" : "");
        if (sum > MONTH) print("  warning: the run takes %s\n", duration(sum, text));
    }
    free(found);
    return good ? sum : -1;
}

/* Returns the run's seconds; 0: not known. */
static double print_known(struct run *r, const struct costs *n) {
    static const char *const name[] = {"flow", "interface", "bonds", "samples", "files"};
    const struct speed_sample like = speed_sample_for(r);
    const struct speed_estimate known = speed_lookup(&like);
    const int *m = r->scene->domain.cells;
    const double cells = r->fluid ? (double)m[0] * m[1] * m[2] : 0;
    double work[SPEED_PARTS], seconds[SPEED_REST], sum = 0;
    char text[BRIEF], age[BRIEF];
    int lacks = 0;
    speed_amounts(r, n->steps, n->steps * cells, n->sweeps, work);
    speed_outputs(r, 0, (long)n->steps, work);
    if (!(work[0] + work[1] + work[2] > 0)) { /* what other runs took says nothing of it */
        print("  %-10s not known: %s\n", "time",
              n->relaxes ? "relaxations take as many steps as they need"
                         : "particles without bonds and without a fluid are not measured in runs; frana check "
                           "--measure says it");
        return 0;
    }
    if (known.samples == 0) {
        print(
            "  %-10s no measurement on this machine yet: a run of 20 s or more, frana check --measure, or frana bench "
            "makes one\n",
            "time");
        return 0;
    }
    for (int p = 0; p < SPEED_REST; p++) {
        seconds[p] = 1e-9 * work[p] * known.part[p] / par_size();
        sum += seconds[p];
        lacks |= work[p] > 0 && !(known.part[p] > 0);
    }
    if (sum <= 0) {
        print("  %-10s not known: the runs on this machine had other parts; a run of 20 s or more, or frana check "
              "--measure, says it\n",
              "time");
        return 0;
    }
    const double whole = sum * (1 + known.part[SPEED_REST]);
    if (whole < 1 && !lacks && !n->relaxes) {
        print("  %-10s less than 1 s on %d rank%s, without start and end\n", "time", par_size(),
              par_size() > 1 ? "s" : "");
        return 0;
    }
    print("  %-10s %s%s on %d rank%s:", "time", lacks || n->relaxes ? "more than " : "about ", duration(whole, text),
          par_size(), par_size() > 1 ? "s" : "");
    for (int p = 0; p < SPEED_REST; p++)
        if (work[p] > 0 && !(known.part[p] > 0))
            print(" %s not known,", name[p]);
        else if (work[p] > 0)
            print(" %s %s,", name[p], duration(seconds[p], text));
    print(" else %s\n", duration(whole - sum, text));
    print("  %-10s from %d run%s of %s scenes on %s on this machine, the newest %s old\n", "", known.samples,
          known.samples > 1 ? "s" : "", known.same_kind ? "such" : "other",
          known.same_ranks ? "as many ranks" : "any number of ranks",
          duration(fmax((double)time(NULL) - known.newest, 0), age));
    if (known.same_kind && known.apart > SPEED_NEAR)
        print(
            "  %-10s their cells, particles or bonds are up to %.2g times more or fewer than those of this scene: the "
            "time may be several times off. frana check --measure says it\n",
            "", known.apart);
    if (whole > MONTH) print("  warning: the run takes %s\n", duration(whole, text));
    return lacks || n->relaxes ? 0 : whole;
}

void costs_print(const struct costs *c, struct run *r, const struct outputs *outputs, const char *out, int measured) {
    r->stage = 0;
    print("\nforecast\n");
    check_intrinsic_print_rigid(r);
    print_steps(r, c);
    print_disk(r, outputs, c, out);
    print_broken(r);
    for (int k = 0; k < c->warnings; k++) print("  warning: %s\n", c->warning[k]);
    double seconds = measured ? print_measured(r) : -1;
    if (seconds < 0) seconds = print_known(r, c);
    check_intrinsic_print(r, seconds, measured);
}
