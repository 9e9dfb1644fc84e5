/* Makes the missing runs of a plan, one after another. */
#pragma once
#include "study/runs/plan.h"

/* program: the frana to start. fresh: no existing run is kept. Returns 0, or the exit code for the end of the program
 * if a signal has stopped the study. The results are in the plan. */
int study_runs_make(struct study_plan *p, const char *program, int fresh);
