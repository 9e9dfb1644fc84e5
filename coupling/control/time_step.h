/* The length of the steps of a run. */
#pragma once
#include "coupling/control/step_control.h"

struct run;

extern const char *const time_step_bound_name[]; /* by enum step_bound */

/* 1: the fluid's limits give the step. Not collective. */
int time_step_is_automatic(const struct run *r);
/* At the start of a stage, before its step is put together. Not collective. */
void time_step_begin_stage(struct run *r);
/* A part of the step: sets its length from the fluid's limits. Collective. */
void time_step_choose(struct run *r);
