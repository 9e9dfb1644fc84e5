/* What is known of the length of a run's steps: limits, bounds, and steps that are made again. */
#pragma once
#include "fluid/fluid.h"
#include "solid/step/stable.h"

/* What limits the length of a step. */
enum { STEP_SOLID_BOUNDS = SOLID_BOUND_STRETCH + 1 };
enum step_bound {
    STEP_BOUND_SCENE,      /* given by the scene */
    STEP_BOUND_CONVECTION, /* limit of fluid/fluid.h */
    STEP_BOUND_DIFFUSION,
    STEP_BOUND_GROWTH,   /* a step is at most a fifth longer than the one before */
    STEP_BOUND_REPEAT,   /* a rejected step is made again, shorter */
    STEP_BOUND_BREAKING, /* bonds may break: a longer step breaks too many */
    STEP_BOUND_FIRST,    /* in the first step of a stage the fluid may not have felt the solid yet */
    STEP_BOUNDS
};

struct step_control {
    double dt_max;      /* s, upper limit of the coming step: INFINITY, or the length with which a rejected step is made
                         * again */
    int substeps_min;   /* in it: 0, or the number with which a rejected step is made again */
    int repeats;        /* number of times that the present step was made again */
    int substeps_usual; /* of its first attempt, where no part of the step sets the number; else 0 */
    int strain_alone;   /* 1: the number of substeps follows nothing but stretched bonds */
    int replays;        /* 1: earlier steps are repeated, to get back to the state before a rejected step; nothing is
                         * logged */
    /* State (coupling/run_state.c): m, by which two particles may have come nearer since contact was last checked. */
    double approach;
    double gap; /* m, by which two bodies were farther apart then than contact reaches; 0: not known, or near */
    struct fluid_limits limits; /* after the last step, if limits_step is its number */
    long limits_step;
    double dt_first;               /* s, the first step of the stage */
    enum step_bound bound, logged; /* of the present step; the one logged last */
    int steps_bound;               /* number of steps in a row that `bound` has limited */
    /* counts since the run began or was resumed */
    long bound_steps[STEP_BOUNDS], substep_bound_steps[STEP_SOLID_BOUNDS], repeated;
};
