/* Makes the runs of a plan that are not there yet, one after the other. */
#pragma once
#include "study/runs/plan.h"

/* program: what to start as frana. fresh: keeps nothing. Returns 0, or the exit code to leave with where a signal has
 * stopped it. What a run gave stands in the plan afterwards. */
int study_runs_make(struct study_plan *p, const char *program, int fresh);
