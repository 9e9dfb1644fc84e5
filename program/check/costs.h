/* frana check: what a run will cost in steps, files and time. */
#pragma once
#include "coupling/control/timescale.h"
#include "program/output/outputs.h"

enum { COSTS_WARNINGS = 4 };
/* Steps and sweeps of a run, summed over its stages. */
struct costs {
    double steps, substeps, sweeps;
    double seconds;    /* of simulated time, s; automatic steps are taken at their foreseen limits */
    double moves_from; /* the time at which the solid first moves or relaxes, s; `moves`: whether it does */
    int moves;
    int at_most, relaxes; /* a stage may end earlier; a stage finds an equilibrium */
    int warnings;
    char warning[COSTS_WARNINGS][TIMESCALE_SENTENCE]; /* on time scales that differ too much */
};
/* The steps of the present stage, after step_begin_stage: at most its `steps`, or as many as its duration takes by the
 * step that is known before a run. Not collective. */
double costs_stage_steps(const struct run *r);
/* Adds the present stage, after step_begin_stage. Collective. */
void costs_add(struct costs *c, struct run *r);
/* Prints steps, sweeps, bytes of the files, and the time, from what earlier runs on this machine took
 * (program/check/speed.h) or, with measure, from steps that are taken here: some of each stage, within about 10 s in
 * all. out: a folder on the disk that the run will write. Rank 0 prints. Collective. */
void costs_print(const struct costs *c, struct run *r, const struct outputs *outputs, const char *out, int measure);
