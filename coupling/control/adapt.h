/* The length of the steps of a run, the number of solid substeps in them, the limits of both, and the decision whether
 * a step that was taken is accepted. */
#pragma once
#include "fluid/fluid.h"
#include "solid/step/stable.h"

struct run;

/* What limits the length of a step. */
enum { ADAPT_SOLID_BOUNDS = SOLID_BOUND_CONTACT + 1 };
enum adapt_bound {
    ADAPT_GIVEN,      /* by the scene */
    ADAPT_CONVECTION, /* limit of fluid/fluid.h */
    ADAPT_DIFFUSION,
    ADAPT_GROWTH, /* a step is at most a fifth longer than the one before */
    ADAPT_AGAIN,  /* a rejected step is made again, shorter */
    ADAPT_BOUNDS
};
extern const char *const adapt_bound_name[]; /* by enum adapt_bound */

struct adapt {
    double most; /* s, upper limit of the coming step: INFINITY, or the length with which a rejected step is made
                  * again */
    int least;   /* least number of substeps in it: 0, or the number with which a rejected step is made again */
    int tries;   /* number of times that the present step was made again */
    int usual;   /* number of substeps of its first attempt, where no part of the step sets the number; else 0 */
    int replays; /* 1: earlier steps are repeated, to get back to the state before a rejected step; nothing is logged */
    /* State (coupling/run_state.c): m, by which two particles may have come nearer since contact was looked at. */
    double approach;
    struct fluid_limits limits; /* after the last step, if limits_of is its number */
    long limits_of;
    double first;                 /* s, the first step of the stage */
    enum adapt_bound bound, said; /* of the present step; the one logged last */
    int since;                    /* number of steps in a row that `bound` has limited */
    /* counts since the run began or was resumed */
    long ruled[ADAPT_BOUNDS], substeps_ruled[ADAPT_SOLID_BOUNDS], again;
};

/* At the start of a stage, before its step is put together. Not collective. */
void adapt_begin(struct run *r);
/* Parts of a step: set its length from the fluid's limits, and the number of substeps from the solid's. Collective. */
void adapt_time_step(struct run *r);
void adapt_substeps(struct run *r);
/* The least number of substeps that is stable with the present contact, with the stage's safety. Collective. */
int adapt_substeps_wanted(struct run *r);

/* This rank's numbers for adapt_judge, to be reduced by max; failed: of step_check. Not collective. */
enum { ADAPT_FAILED, ADAPT_RATE, ADAPT_FASTEST, ADAPT_NUMBERS };
void adapt_look(const struct run *r, int failed, double number[ADAPT_NUMBERS]);
/* Decides whether a step is accepted, from the largest numbers of all ranks; sets the limits of the next step. A step
 * is rejected if a value is NaN or beyond reason; if an automatic step exceeds the limit of the velocities that it led
 * to; if an automatic number of substeps is unstable with new contact. A rejected step is to be made again, shorter or
 * with more substeps, or the run is lost; status says why, the same on all ranks. Collective. */
enum adapt_verdict { ADAPT_HOLDS, ADAPT_MAKE_AGAIN, ADAPT_LOST };
enum adapt_verdict adapt_judge(struct run *r, const double number[ADAPT_NUMBERS], struct step_status *status);
/* To be called before a rejected step is made again, in the state before it: sets the number of substeps where no part
 * of the step does. Not collective. */
void adapt_again(struct run *r);
/* To be called when the repeated step was accepted. Not collective. */
void adapt_made(struct run *r);

/* Describes which limit a step of dt with its substeps exceeds in the present state, and which step would be stable;
 * else how near it is to the nearest limit. Collective. */
void adapt_explain(struct run *r, double dt, int substeps, char *text, size_t size);
