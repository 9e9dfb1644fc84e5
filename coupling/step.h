/* The time step, put together from the parts that a stage needs.  (001: sec. 4.3) */
#pragma once
#include "coupling/run.h"

/* Puts the step of the present stage together. Collective. */
void step_begin_stage(struct run *r);
/* One step: every part in turn. Collective. */
void step_advance(struct run *r);
/* NaN or beyond reason on this rank. Unless `whole`, of the fluid one plane of p is looked at only, for NaN: the
 * Poisson solve carries one to every cell, while a velocity beyond reason may hide. Not collective (agree with
 * step_status_agree). */
int step_check(const struct run *r, int whole, struct step_status *status);
