/* Wall seconds by part of the program, and those of them that were spent waiting for other ranks. Parts nest: an inner
 * part's time is not counted in the outer one's. Time outside of all clocks counts in a part that clock_default
 * chooses, so that all parts together are the time since clock_clear. */
#pragma once

enum clock_part {
    CLOCK_MOMENTUM,
    CLOCK_POISSON,
    CLOCK_HALO,
    CLOCK_FORCING,
    CLOCK_PROBE,
    CLOCK_SOLID,
    CLOCK_CONTACT,
    CLOCK_INTERFACE,
    CLOCK_COUPLING, /* joins fluid and solid within a step: iterations, starting guesses, balances */
    CLOCK_JUDGING,  /* chooses the step and the substeps, tests whether a step holds; all ranks agree */
    CLOCK_KEEPING,  /* keeps states in memory for steps that are made again, and restores them */
    CLOCK_OUTPUT,
    CLOCK_SETUP, /* before the first step, and where a stage begins */
    CLOCK_OTHER, /* in no clock */
    CLOCK_PARTS,
    /* details of a part: their time also counts in that part */
    CLOCK_FORWARD = CLOCK_PARTS, /* of poisson: divergence and forward transforms */
    CLOCK_COLUMNS,               /* of poisson: the last direction's solve */
    CLOCK_BACKWARD,              /* of poisson: backward transforms and correction */
    CLOCK_CRACKS,                /* of solid: pressures in cracks */
    CLOCK_SERIES,                /* of output: tables, samples included */
    CLOCK_FIELDS,                /* of output: files of fields */
    CLOCK_CHECKPOINT,            /* of output: checkpoints, with the run.json beside each */
    CLOCK_LOG,                   /* of output: the log and the progress on the terminal */
    CLOCK_PERMEABILITY,          /* of output: intrinsic.csv */
    CLOCK_ALL
};

/* Phases between the command and the first step, and after the last step. They follow each other, and do not nest. */
enum clock_phase {
    CLOCK_PHASE_LAUNCH, /* MPI */
    CLOCK_PHASE_SCENE,  /* the scene is read and tested */
    CLOCK_PHASE_FLUID,
    CLOCK_PHASE_PLANS, /* of the transforms */
    CLOCK_PHASE_SOLID, /* particles, ghosts, materials */
    CLOCK_PHASE_BONDS, /* families, initial cracks */
    CLOCK_PHASE_SURFACE,
    CLOCK_PHASE_FORCING, /* and the medium */
    CLOCK_PHASE_LIMITS,  /* stages' parts, stable steps of the solid */
    CLOCK_PHASE_OUTPUT,  /* files are opened, a checkpoint is read */
    CLOCK_PHASES,
    CLOCK_PHASE_STEPS = CLOCK_PHASES,
};

/* A part that begins within a detail of itself runs as that detail. */
void clock_begin(enum clock_part part); /* Not collective. */
void clock_end(enum clock_part part);   /* Not collective. */
void clock_default(
    enum clock_part part); /* Time outside of all clocks counts in this part from now on. Not collective. */
void clock_clear(void);    /* A new run begins: all seconds are 0. Not collective. */
void clock_count(void);    /* Counts the time up to now, before seconds are read. Not collective. */
double clock_seconds(enum clock_part part); /* a part's with those of its details */
double clock_waiting(enum clock_part part); /* of them, within MPI (base/par_wait.h) */
const char *clock_name(enum clock_part part);
enum clock_part clock_owner(enum clock_part detail); /* the part that a detail belongs to; a part itself */

/* A phase begins and the one before it ends; returns that one. While the steps run nothing but clock_clear leaves their
 * phase. Not collective. */
enum clock_phase clock_phase(enum clock_phase phase);
double clock_phase_seconds(enum clock_phase phase);
const char *clock_phase_name(enum clock_phase phase);
