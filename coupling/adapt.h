/* The steps that a run takes: how long they are, how many substeps the solid takes in them, what bounds them, and
 * whether a step that has been taken holds. */
#pragma once
#include "fluid/fluid.h"
#include "solid/step/stable.h"

struct run;

/* What decides on the length of a step. */
enum { ADAPT_SOLID_BOUNDS = SOLID_BOUND_CONTACT + 1 };
enum adapt_bound {
    ADAPT_GIVEN,      /* by the scene */
    ADAPT_CONVECTION, /* fluid/fluid.h */
    ADAPT_DIFFUSION,
    ADAPT_GROWTH, /* a step is at most a fifth longer than the one before */
    ADAPT_AGAIN,  /* a step that did not hold is made again */
    ADAPT_BOUNDS
};
extern const char *const adapt_bound_name[]; /* by enum adapt_bound */

struct adapt {
    double most; /* s, the coming step is no longer: INFINITY, or what one is made again with */
    int least;   /* substeps in it, at least: 0, or what one is made again with */
    int tries;   /* times that the present step has been made again */
    int replays; /* 1: steps that have been are made once more, to come to the state before another: nothing is said */
    /* State (coupling/run_state.c): m, by which two particles may have come nearer since contact was looked at. */
    double approach;
    struct fluid_limits limits; /* after the last step, where limits_of is its number */
    long limits_of;
    double first;                 /* s, the first step of the stage */
    enum adapt_bound bound, said; /* of the present step; in the log */
    int since;                    /* steps that `bound` has decided on in a row */
    /* since the run began, or was resumed */
    long ruled[ADAPT_BOUNDS], substeps_ruled[ADAPT_SOLID_BOUNDS], again;
};

/* At the start of a stage, before its parts are put together. Not collective. */
void adapt_begin(struct run *r);
/* Parts of a step: its length by the fluid's limits; the number of substeps by the solid's. Collective. */
void adapt_time_step(struct run *r);
void adapt_substeps(struct run *r);
/* The least number of substeps that is stable with what touches now, within the stage's safety. Collective. */
int adapt_substeps_wanted(struct run *r);

/* What this rank knows of a step that has been taken, for a reduction to the largest; failed: of step_check. Not
 * collective. */
enum { ADAPT_FAILED, ADAPT_RATE, ADAPT_FASTEST, ADAPT_NUMBERS };
void adapt_look(const struct run *r, int failed, double number[ADAPT_NUMBERS]);
/* Whether it holds, by the largest numbers of all ranks; the next one's limits are then known. It does not where
 * something is no number or beyond reason; where an automatic step has become longer than the limit of the velocities
 * that it led to; where contact has come about that an automatic number of substeps is unstable with. If so it is to be
 * made again, shorter or with more substeps, or nothing helps; status says what is wrong, agreed on. Collective. */
enum adapt_verdict { ADAPT_HOLDS, ADAPT_MAKE_AGAIN, ADAPT_LOST };
enum adapt_verdict adapt_judge(struct run *r, const double number[ADAPT_NUMBERS], struct step_status *status);
/* The step that was made again holds. Not collective. */
void adapt_made(struct run *r);

/* What limit a step of dt with its substeps is beyond in the present state, and what would be stable; or how near it is
 * to the nearest one. Collective. */
void adapt_explain(struct run *r, double dt, int substeps, char *text, size_t size);
