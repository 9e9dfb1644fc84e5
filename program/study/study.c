/* frana study: plans the runs, lists them, makes all or one of them, writes the report. */
#include "program/study/study.h"
#include "base/die.h"
#include "base/launcher.h"
#include "base/arena.h"
#include "postproc/gnuplot.h"
#include "program/study/gates/gates.h"
#include "program/study/report/report.h"
#include "program/study/runs/child.h"
#include "program/study/runs/runs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The path of this program's executable. */
static void program_of(char *path, size_t size) {
    const ssize_t n = readlink("/proc/self/exe", path, size - 1);
    if (n <= 0) die_all(EXIT_CODE_FILE, "study: cannot find its own program in /proc/self/exe");
    path[n] = '\0';
}

/* Sets environment variables for the commands of quantities, and those for the launcher of the runs. */
static void environment(const struct study *s, const char *program) {
    char *folder = arena_keep(realpath(s->folder, NULL));
    setenv("FRANA", program, 1);
    setenv("FRANA_STUDY", folder ? folder : s->folder, 1);
    launcher_allow();
}

static int count(const struct study_plan *p, enum study_state state) {
    int n = 0;
    for (int i = 0; i < p->runs; i++) n += p->run[i].outcome.state == state;
    return n;
}

/* The tables, the page and the plots. Returns whether all plots were drawn. */
static int write_all(struct study_result *r, const char *out) {
    const struct study_maker maker = study_report_maker();
    if (r->plan->study->is_sweep) return study_sweep_write(r, &maker, out);
    const int plotted = study_chart_draw(r, out);
    study_csv_write(r, &maker, out);
    study_page_write(r, &maker, out);
    return plotted;
}

static int report(const struct study_plan *p, const char *out) {
    struct study_result *r = study_result_new(p);
    study_child_note(0);
    const int plotted = write_all(r, out);
    postproc_gnuplot_end();
    study_child_note(1);
    int drawn = 0;
    for (int q = 0; q < r->tables; q++) drawn |= r->table[q].plotted;
    const int done = count(p, STUDY_DONE), failed = count(p, STUDY_FAILED);
    printf("%s: %s.csv, %s.md%s, of %d runs\n", out, p->study->name, p->study->name, plotted && drawn ? ", plots" : "",
           done);
    if (!plotted)
        fprintf(stderr, "frana: %s: plots are missing: gnuplot was not found or failed; their scripts are there\n",
                out);
    if (failed) fprintf(stderr, "frana: %s: %d runs have failed\n", p->study->path, failed);
    return done ? EXIT_CODE_DONE : EXIT_CODE_UNSTABLE;
}

/* Writes the report of the runs that are there, and says which are not. */
static int collect(struct study_plan *p, const char *out) {
    const int missing = study_runs_collect(p);
    if (missing < 0) {
        fprintf(stderr, "frana: %s: stopped while the runs were read: nothing is written\n", p->study->path);
        return EXIT_CODE_REQUEUE;
    }
    if (missing == p->runs) {
        fprintf(stderr, "frana: %s: none of the %d runs has been made, so there is nothing to report\n", p->study->path,
                p->runs);
        return EXIT_CODE_REQUEUE;
    }
    const int code = report(p, out);
    if (!missing) return code;
    fprintf(stderr, "frana: %s: %d of %d runs are missing: ", p->study->path, missing, p->runs);
    study_runs_say_missing(p, stderr);
    return EXIT_CODE_REQUEUE;
}

static int one(struct study_plan *p, const char *program, const struct study_options *o) {
    if (o->number > p->runs) die_all(EXIT_CODE_SCENE, "study --run %d: %s has %d runs", o->number, o->file, p->runs);
    return study_runs_make_one(p, program, o->fresh, o->number - 1);
}

static int execute(struct study_plan *plan, const char *program, const char *out, const struct study_options *o) {
    int code = EXIT_CODE_DONE;
    switch (o->task) {
    case STUDY_LIST:
        study_runs_list(plan);
        return code;
    case STUDY_ONE:
        return one(plan, program, o);
    case STUDY_COLLECT:
        return collect(plan, out);
    case STUDY_ALL:
        break;
    }
    code = study_runs_make(plan, program, o->fresh);
    return code == EXIT_CODE_DONE ? report(plan, out) : code;
}

static int run_study(const struct study_options *o, const char *program) {
    struct study *s = study_file_new(o->file);
    char *out = o->out ? arena_text("%s", o->out) : arena_text("%s/results", s->folder);
    struct study_plan *plan = study_plan_new(s, out);
    environment(s, program);
    study_child_begin();
    const int code = execute(plan, program, out, o);
    return code;
}

int study_run(const struct study_options *o) {
    char program[4096];
    if (launcher_started())
        die_all(EXIT_CODE_SCENE, "study: starts the ranks of its runs itself: call it without mpiexec");
    program_of(program, sizeof program);
    if (study_gates_is(o->file)) return study_gates_run(o, program, run_study);
    if (o->results || o->quick) {
        study_file_new(o->file); /* what is wrong with the file is said first */
        die_all(EXIT_CODE_SCENE, "study: --results and --quick go with a file of gates only");
    }
    return run_study(o, program);
}
