/* The start of a stage: the needs of its steps, and the numbers that it starts with. */
#pragma once
#include "coupling/run.h"

/* Needs of the steps of a stage. A set of them selects the parts (coupling/step.c) of a step. */
enum stage_need {
    STAGE_RELAXES = 1,    /* the solid goes to static equilibrium; the stage needs nothing else */
    STAGE_FLUID = 2,      /* a fluid moves */
    STAGE_AUTOMATIC = 4,  /* the fluid's limits give the time step */
    STAGE_IMPLICIT = 8,   /* the fluid's diffusion is implicit */
    STAGE_ELASTIC = 16,   /* a solid moves and deforms */
    STAGE_IMMERSED = 32,  /* a solid, moving or at rest, is immersed in the fluid */
    STAGE_REFINES = 64,   /* a plate may get smaller particles */
    STAGE_TOUCHES = 128,  /* particles without a common bond may meet */
    STAGE_FOLLOWS = 256,  /* the number of substeps follows contact and the time step */
    STAGE_REACTS = 512,   /* the load is the forcing's reaction, found within the fluid's stages */
    STAGE_RAISES = 1024,  /* loads go on in increments, each to static equilibrium; the stage needs nothing else */
    STAGE_SEEPS = 2048,   /* fluid flows in the solid's cracks */
    STAGE_SETTLES = 4096, /* the solid goes to rest: the frequency of its slowest motion is followed */
    STAGE_LASTS = 8192,   /* the stage has a duration */
    STAGE_ALL_NEEDS = 16383
};

/* The set of needs of stage k. can_touch: solid_contact_is_possible, for a scene with contact. Depends on its arguments
 * only. Not collective. */
unsigned stage_needs_of(const struct scene *scene, int k, int can_touch);

/* 1: the present stage has taken all its steps, has reached its duration, or is steady. Not collective. */
int stage_has_ended(const struct run *r);

/* Sets the numbers of the run's present stage, at its start or, in a resumed run, in the middle of it: the integrator,
 * the solid's stable step, the time step unless it is automatic, the number of substeps. Dies (exit 2) on a step that
 * the solid cannot take. Returns the needs. Collective. */
unsigned stage_begin(struct run *r);
