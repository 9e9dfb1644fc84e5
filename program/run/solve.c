/* frana run and frana check of scenes that are solved at once: the run folder, the phases with their times, run.json.
 */
#include "program/run/solve.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "base/signals.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "meshless/problem/problem.h"
#include "program/output/build_info.h"

#include <stdio.h>
#include <stdlib.h>

enum { PHASES = 16 };

struct solve {
    const struct scene *scene;
    const struct meshless_problem *kind;
    void *problem;
    double start, phase[PHASES], output; /* s */
};

int solve_is(const struct scene *scene) { return meshless_problem_of(scene) != NULL; }

/* Runs the phases from .. to - 1 (-1: to the last). */
static void run_phases(struct solve *s, int from, int to) {
    for (int k = from; k != to && s->kind->phase[k].name; k++) {
        ENSURE(k < PHASES, "more than %d phases", PHASES);
        const double start = par_seconds();
        s->kind->phase[k].run(s->problem);
        par_barrier();
        s->phase[k] = par_seconds() - start;
    }
}

static void begin(struct solve *s, const struct scene *scene) {
    *s = (struct solve){.scene = scene, .kind = meshless_problem_of(scene), .start = par_seconds()};
    s->problem = s->kind->new (scene);
    run_phases(s, 0, s->kind->checked);
}

static void write_run_json(const struct solve *s, const char *folder) {
    char path[FOLDER_PATH];
    const int size = par_size();
    const double wall = par_max(par_seconds() - s->start), peak = (double)memory_peak();
    double *peaks = malloc((size_t)size * sizeof *peaks);
    ENSURE(peaks, "no memory for %d ranks", size);
    par_gather(&peak, sizeof peak, peaks);
    if (par_rank() == 0) {
        struct json *j = json_begin(folder_path(path, folder, "run.json"));
        json_text(j, "title", s->scene->title);
        json_text(j, "status", "done");
        json_long(j, "exit_code", EXIT_CODE_DONE);
        json_long(j, "steps", 0);
        json_long(j, "ranks", size);
        json_number(j, "wall_seconds", wall);
        json_number(j, "setup_seconds", 0);
        json_object(j, "wall_seconds_by_part");
        for (int k = 0; s->kind->phase[k].name; k++) json_number(j, s->kind->phase[k].name, s->phase[k]);
        json_number(j, "output", s->output);
        json_close(j);
        s->kind->write_json(s->problem, j);
        json_array(j, "peak_memory_bytes_per_rank");
        for (int k = 0; k < size; k++) json_number(j, NULL, peaks[k]);
        json_close(j);
        build_info_write(j);
        json_end(j);
    }
    free(peaks);
}

static void refuse_options(const struct command *c, int archives) {
    if (c->resume)
        die_all(EXIT_CODE_SCENE, "--resume: a scene that is solved at once has no checkpoint; run it again without");
    if (!archives && folder_has_run(c->out))
        die_all(EXIT_CODE_FILE, "%s holds a run already: --out DIR writes elsewhere", c->out);
}

int solve_run(const struct command *c, const struct scene *scene) {
    struct solve s;
    char path[FOLDER_PATH], archive[FOLDER_PATH];
    refuse_options(c, c->archives);
    signals_begin(c->max_wall);
    signals_at_once(2); /* there is no state to keep */
    begin(&s, scene);
    if (c->archives) folder_archive(c->out, archive);
    folder_make(c->out);
    folder_hold(c->out);
    refuse_options(c, 0); /* the folder is locked: no other run can write there */
    log_begin(c->out, c->quiet, 0);
    log_line("frana: %s", scene->title);
    if (c->archives) log_line("the run that was here had not ended: its files are in %s", archive);
    if (par_rank() == 0) {
        struct atomic_write a;
        atomic_write_begin(&a, folder_path(path, c->out, "scene.resolved.yaml"));
        fputs(scene->resolved, a.file);
        atomic_write_end(&a);
    }
    run_phases(&s, s.kind->checked, -1);
    const double written = par_seconds();
    s.kind->write(s.problem, scene, c->out);
    s.output = par_seconds() - written;
    write_run_json(&s, c->out);
    for (int k = 0; s.kind->phase[k].name; k++) log_line("%s: %.3g s", s.kind->phase[k].name, s.phase[k]);
    log_line("done: solved in %.3g s", par_seconds() - s.start);
    s.kind->free(s.problem);
    log_end();
    folder_hold_release();
    return EXIT_CODE_DONE;
}

int solve_check(const struct scene *scene) {
    struct solve s;
    begin(&s, scene);
    print("%s\n", scene->title);
    s.kind->check(s.problem);
    double bytes = 0;
    for (int p = 0; p < MEMORY_PARTS; p++) bytes += (double)memory_bytes((enum memory_part)p);
    const double all = par_sum(bytes), most = par_max(bytes);
    print("  memory     %.3g MB on %d ranks, at most %.3g MB on one\n", all * 1e-6, par_size(), most * 1e-6);
    s.kind->free(s.problem);
    return EXIT_CODE_DONE;
}
