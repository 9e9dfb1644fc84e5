/* Compares momentum and energy of a flow without bodies, over the step before some rows of series.csv, with what acts
 * on it. */
#pragma once
#include "fluid/fluid.h"

struct run;

struct flow_balance {
    long rows;    /* how many have been looked for */
    int prepared; /* 1: `before` is set */
    struct fluid_measures before;
};

/* The force by which round-off might change the fluid's momentum, a million times over: by the momentum itself, and by
 * pressures and sources that cancel, N. Not collective. */
double flow_balance_least_force(struct run *r, double kinetic_energy);
/* Before the step of a row: takes what the balances begin with, at the first row and the second, the fourth, the eighth
 * and so on. Collective. */
void flow_balance_prepare(struct flow_balance *b, struct run *r);
/* The step is not sampled. Collective. */
void flow_balance_cancel(struct flow_balance *b, struct run *r);
/* After the step, with its measures: warns in the log of what does not close (coupling/control/sample_watch.h).
 * Collective. */
void flow_balance_check(struct flow_balance *b, struct run *r, const struct fluid_measures *now);
