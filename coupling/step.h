/* The time step, put together from the parts that a stage needs.  (001: sec. 4.3) */
#pragma once
#include "coupling/run.h"

/* A line of the pipeline: a stage has the part if it has all needs of `with` and none of `without` (coupling/stage.h).
 */
struct step_part {
    const char *name;
    enum clock_part clock; /* of what runs in none of its own */
    unsigned with, without;
    run_part *run;
};
/* The parts of a step with these needs, in order; returns how many. Not collective. */
int step_parts_of(unsigned needs, const struct step_part *part[RUN_PARTS_MAX]);

/* Makes the list of the present stage's step. Collective. */
void step_begin_stage(struct run *r);
/* One step: calls every part in turn. Returns 0 if the program shall stop and the step was given up (r->solid->stops):
 * the state is then that of no step, but for a relaxation, which leaves a state to go on from. Collective. */
int step_advance(struct run *r);
/* Finds NaN and values beyond reason on this rank. Unless `all_fields`, only one plane of p is tested, for NaN: the
 * Poisson solve spreads a NaN to every cell, but a velocity beyond reason is not found then. Not collective (agree with
 * step_status_agree). */
int step_check(const struct run *r, int all_fields, struct step_status *status);
