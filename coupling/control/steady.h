/* The end of a stage that waits until a quantity is steady: stages[].until. */
#pragma once

struct run;

/* What is known of the present stage. All 0: nothing yet. */
struct steady {
    double first, low, high; /* of the samples in the present window */
    double spread;           /* high - low of the last window */
    long samples;            /* in the present window, the last window's last one included */
    long windows;            /* complete ones */
    long ended;              /* 1: the stage has ended */
};

/* A quantity at the end of a window. */
struct steady_found {
    double value, spread, left; /* spread and what is left, relative to |value|; NaN: not known yet */
};

/* Forgets the stage before. To be called when a stage begins. Not collective. */
void steady_begin(struct run *r);
/* 1: the quantity is to be sampled after this step of the present stage. Not collective. */
int steady_is_due(const struct run *r, long stage_step);
/* 1: the stage may end with this step. Not collective. */
int steady_may_end(const struct run *r, long stage_step);
/* Samples the quantity. Returns 1 if the stage ends here. found: set at a window's end. Collective. */
int steady_sample(struct run *r, struct steady_found *found);
/* 1: the present stage waits for a quantity, and has ended. Not collective. */
int steady_has_ended(const struct run *r);
