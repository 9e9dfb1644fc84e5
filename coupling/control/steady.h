/* The end of a stage that waits until a quantity is steady, or all is at rest: stages[].until. */
#pragma once
#include "coupling/control/trend.h"

struct run;

/* The quantities that a stage waits for: the permeability alone; or, until all is at rest, those of the parts that the
 * scene has. */
enum steady_quantity { STEADY_PERMEABILITY, STEADY_STRAIN = 0, STEADY_FLOW, STEADY_LOAD, STEADY_QUANTITIES };

/* What is known of the present stage. All 0: nothing yet. */
struct steady {
    double first[STEADY_QUANTITIES], low[STEADY_QUANTITIES], high[STEADY_QUANTITIES]; /* in the present window */
    double spread[STEADY_QUANTITIES]; /* high - low of the last window */
    double most[STEADY_QUANTITIES];   /* the largest magnitude in the stage */
    double moving;                    /* the largest kinetic over strain energy in the present window */
    double left[STEADY_QUANTITIES];   /* the most that was expected to come since all has been steady */
    double quiet;                     /* s, for which all has been steady */
    long samples;                     /* in the present window, the last window's last one included */
    long windows;                     /* complete ones */
    long ended;                       /* 1: the stage has ended */
    struct trend trend;               /* of the permeability; the members above are those of all that is to rest */
};

/* At the end of a window. */
struct steady_found {
    double value[STEADY_QUANTITIES];                           /* m2; or J, J, N. NaN: the scene has no such part */
    double spread[STEADY_QUANTITIES], left[STEADY_QUANTITIES]; /* over the value, or where all is to rest over its
                                                                * largest one; NaN: not known yet */
    double moving;                                             /* as above */
    long windows;                                              /* of which the spread is */
    int ramps;                                                 /* 1: a load or constraint still changes */
};

/* Forgets the stage before. To be called when a stage begins. Not collective. */
void steady_begin(struct run *r);
struct steady_found steady_nothing(void); /* nothing is known */
/* 1: the quantity is to be sampled after this step of the present stage. Not collective. */
int steady_is_due(const struct run *r, long stage_step);
/* 1: the stage may end with this step. Not collective. */
int steady_may_end(const struct run *r, long stage_step);
/* Samples the quantities. Returns 1 if the stage ends here. found: set at a window's end. Collective. */
int steady_sample(struct run *r, struct steady_found *found);
/* 1: the present stage waits for a quantity, and has ended. Not collective. */
int steady_has_ended(const struct run *r);
