/* The start of a stage: the needs of its steps, and the numbers that it starts with. */
#pragma once
#include "coupling/run.h"

/* What the steps of a stage need. The set of needs selects the parts of a step (coupling/step.c). */
enum stage_need {
    STAGE_RELAXATION = 1,           /* the solid is relaxed to static equilibrium; the stage has no other need */
    STAGE_FLUID = 2,                /* a fluid moves */
    STAGE_AUTOMATIC_STEP = 4,       /* the fluid's limits give the time step */
    STAGE_IMPLICIT = 8,             /* the fluid's diffusion is implicit */
    STAGE_ELASTIC = 16,             /* a solid moves and deforms */
    STAGE_IMMERSED = 32,            /* a solid, moving or at rest, is immersed in the fluid */
    STAGE_REFINEMENT = 64,          /* particles of a plate may be replaced by smaller ones */
    STAGE_CONTACT = 128,            /* particles that no bond joins may touch */
    STAGE_AUTOMATIC_SUBSTEPS = 256, /* the number of substeps depends on contact and on the time step */
    STAGE_REACTION = 512,           /* the load is the forcing's reaction, computed within the fluid's stages */
    STAGE_INCREMENTS = 1024,        /* loads grow in increments, each to equilibrium; the stage has no other need */
    STAGE_CRACK_FLUID = 2048,       /* fluid flows in the solid's cracks */
    STAGE_SETTLING = 4096,          /* the solid comes to rest, damped by the frequency of its slowest motion */
    STAGE_DURATION = 8192           /* the stage has a duration */
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
