/* Ends a stage at its duration: shortens the last steps. */
#include "coupling/control/duration.h"
#include "coupling/control/time_step.h"
#include "coupling/run.h"

#include <math.h>

/* The sum of many steps misses the end by round-off: this part of the duration is none. */
static const double ROUNDED = 1e-9;

static double left(const struct run *r) { return r->began[r->stage] + run_stage(r)->duration - r->t; }

int duration_is_over(const struct run *r) {
    return run_stage(r)->duration > 0 && left(r) <= ROUNDED * run_stage(r)->duration;
}

int duration_may_end(const struct run *r) {
    const double longest = (time_step_is_automatic(r) ? TIME_STEP_GROWTH : 1) * r->dt;
    return run_stage(r)->duration > 0 && (r->stage_step == 0 || left(r) <= longest + ROUNDED * run_stage(r)->duration);
}

void duration_shorten_step(struct run *r) {
    const double rest = left(r), rounded = ROUNDED * run_stage(r)->duration;
    if (r->dt >= rest - rounded)
        r->dt = rest;
    else if (time_step_is_automatic(r) && 2 * r->dt > rest)
        r->dt = 0.5 * rest;
}

long duration_steps(const struct run *r) {
    const long most = run_stage(r)->steps;
    if (!(run_stage(r)->duration > 0) || !(r->dt > 0)) return most;
    if (duration_is_over(r)) return r->stage_step;
    const double more = ceil(left(r) / r->dt * (1 - ROUNDED));
    return more < (double)(most - r->stage_step) ? r->stage_step + (long)more : most;
}
