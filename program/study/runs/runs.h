/* Makes the missing runs of a plan, one after another, or one of them; the results are in the plan. */
#pragma once
#include "program/study/runs/plan.h"

#include <stdio.h>

/* program: the frana to start. fresh: no existing run is kept. Returns 0, or the exit code for the end of the program
 * if a signal or the batch system's limit has stopped the study. */
int study_runs_make(struct study_plan *p, const char *program, int fresh);
/* Makes run i, from 0, unless it is there. Returns 0, the run's exit code, or that of a study that was stopped. */
int study_runs_make_one(struct study_plan *p, const char *program, int fresh, int i);
/* Measures the runs that are there. Returns how many are missing; -1: it was stopped, and not all are measured. */
int study_runs_collect(struct study_plan *p);
/* Prints a line for each run: number, state, ranks, folder. */
void study_runs_list(struct study_plan *p);
/* Writes the numbers of the missing runs, with commas, and a newline. */
void study_runs_say_missing(const struct study_plan *p, FILE *to);
