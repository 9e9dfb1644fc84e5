/* The length of the steps of a run. */
#pragma once
#include "coupling/control/step_control.h"

struct run;

extern const char *const time_step_bound_name[]; /* by enum step_bound */

/* An automatic step is at most so many times the last one. */
#define TIME_STEP_GROWTH 1.2

/* 1: the fluid's limits give the step. Not collective. */
int time_step_is_automatic(const struct run *r);
/* At the start of a stage, before its step is put together. Not collective. */
void time_step_begin_stage(struct run *r);
/* A part of the step: sets its length from the fluid's limits. Collective. */
void time_step_choose(struct run *r);
/* The longest automatic step of a stage's first step, s, in which the fluid may not have felt the solid yet: the solid
 * crosses no cell, by its velocity and its body force; and with implicit diffusion the step grows from that of explicit
 * diffusion, which resolves how a body begins to move. INFINITY in stages whose solid stands still. Collective. */
double time_step_first(const struct run *r);
/* The longest automatic step of a stage in which bonds may break in a fluid, s: with longer ones too many break.
 * INFINITY in other stages, where bonds are damped, and where the solid is so heavy that it does not feel the fluid's
 * step. step_begin_stage comes first. Not collective. */
double time_step_breaking(const struct run *r);
/* 1: the immersed solid is so heavy that the length of the fluid's step does not change its motion. Not collective. */
int time_step_is_heavy(const struct run *r);
/* 1: the number of bonds that break in the present stage depends on the length of the fluid's step. Not collective. */
int time_step_counts(const struct run *r);
