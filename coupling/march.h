/* Takes steps: a step is taken and accepted or rejected; a rejected one is repeated from a state saved in memory. */
#pragma once
#include "base/step_status.h"

struct run;
struct march; /* opaque: holds the last good state (coupling/control/rollback.h) */

struct march *march_new(struct run *r); /* r is borrowed. */
void march_free(struct march *m);

/* Saves the present state as the one to go back to: at the start of a stage or of a resumed run, and after a
 * checkpoint. Collective. */
void march_begin(struct march *m);

/* Functions of the caller for a step. */
struct march_caller {
    void *with;
    void (*before)(void *with);                         /* before each attempt; NULL: nothing */
    void (*largest)(void *with, double *number, int n); /* replaces the numbers by the largest of all ranks, in the only
                                                         * reduction of a step; NULL: par_max_array */
};
enum march_end {
    MARCH_FAILED,     /* the step failed, and nothing is left to try; status has the reason */
    MARCH_DONE,       /* the step is done */
    MARCH_INTERRUPTED /* the program shall stop, r->solid->stops; march_interrupt is to follow */
};
/* Takes one step, and repeats it, shorter or with more substeps, as long as it is rejected and these are left to try.
 * all_fields: every value of the fields is tested against its limits, as in every tenth step. Collective. */
enum march_end march_step(struct march *m, int all_fields, const struct march_caller *caller,
                          struct step_status *status);
/* After an interrupted step: keeps what a relaxation has reached, else restores the last good state. Returns the
 * step of the state, -1: there is none. Collective. */
long march_interrupt(struct march *m);
/* To be called after an accepted step and the caller's samples of it. Saves the present state as the one to return
 * to: every 50 steps, and after each step that may take minutes, that was repeated, or in which the solid was
 * refined; the solid's balances are checked first (coupling/control/watch.h). Returns 1, or 0 if so much energy was
 * created that the run must end; status then has the reason. Collective. */
int march_save_state(struct march *m, struct step_status *status);

/* A run that has become unstable. */
struct march_failure {
    long step;      /* of the last good state, -1: there is none */
    char what[256]; /* the fault and its position */
    char why[256];  /* the limit of the last good state that the step exceeded */
};
/* Restores the last good state and explains the fault. status: this rank's. Collective. */
struct march_failure march_abort(struct march *m, struct step_status *status);
