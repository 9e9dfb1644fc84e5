/* A whole run, from its run.json. */
#pragma once
#include "base/files/json_read.h"

/* Of the main case: the thesis's load with either integrator, and the default load with the cheaper
 * settings of cases/porous_channel/economical.sh. */
enum bench_whole_kind { BENCH_WHOLE_VERLET, BENCH_WHOLE_RK3, BENCH_WHOLE_ECONOMICAL };

struct bench_whole {
    double wall_seconds, ranks;
    long from; /* the step at which it was resumed; 0: not resumed */
    enum bench_whole_kind kind;
    struct json_read *record; /* run.json; owned */
};

/* Dies with exit code 4 if the file is missing or if the run has not finished. Not collective. */
struct bench_whole bench_whole_read(const char *path);
void bench_whole_free(struct bench_whole *w);

double bench_whole_number(const struct bench_whole *w, const char *path); /* by base/files/json_read.h */
/* The same in the record of a stage. */
double bench_whole_of_stage(const struct bench_whole *w, const char *stage, const char *path);
/* A part's seconds in a stage, working and waiting. */
double bench_whole_part(const struct bench_whole *w, const char *stage, const char *part);
double bench_whole_sweeps(const struct bench_whole *w); /* of the force, since the run was begun or resumed */
