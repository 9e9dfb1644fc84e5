/* A whole run, from its run.json. */
#pragma once

/* Of the main case: the thesis's load with either integrator, and the default load with the cheaper
 * settings of cases/porous_channel/economical.sh. */
enum bench_whole_kind { BENCH_WHOLE_VERLET, BENCH_WHOLE_RK3, BENCH_WHOLE_ECONOMICAL };

struct bench_whole {
    char title[256];
    double wall_seconds, ranks;
    long from; /* the step at which it was resumed; 0: not resumed */
    enum bench_whole_kind kind;
    char *text; /* the file, owned */
};

/* Dies with exit code 4 if the file is missing or if the run has not finished. Not collective. */
struct bench_whole bench_whole_read(const char *path);
void bench_whole_free(struct bench_whole *w);

/* The number behind the last of some keys or names, of which each follows the one before: "timeline/flow/seconds".
 * run.json is written in one order, so this needs no tree. NAN: there is none. */
double bench_whole_number(const struct bench_whole *w, const char *path);
/* Of one stage by its name, a part's seconds, working and waiting. */
double bench_whole_part(const struct bench_whole *w, const char *stage, const char *part);
double bench_whole_sweeps(const struct bench_whole *w); /* of the force, since the run was begun or resumed */
