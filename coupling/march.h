/* Steps that hold: a step is taken and judged; one that does not hold is made again from a state kept in memory. */
#pragma once
#include "base/step_status.h"

struct run;
struct march; /* opaque: holds the last good state (coupling/guard.h) */

struct march *march_new(struct run *r); /* r is borrowed. */
void march_free(struct march *m);

/* The state at the start of a stage, or of a run that is resumed, is the first to go back to. Collective. */
void march_begin(struct march *m);

/* What the caller adds to a step. */
struct march_caller {
    void *with;
    void (*before)(void *with);                         /* before each attempt; NULL: nothing */
    void (*largest)(void *with, double *number, int n); /* makes the numbers the largest of all ranks: the one
                                                         * reduction of a step; NULL: par_max_array */
};
/* One step. It is made again, shorter or with more substeps, as long as it does not hold and something else can be
 * tried. whole: the whole fields are looked at for what is beyond reason, as they are every tenth step anyway. Returns
 * 1, or 0 where the step is lost; status says what was wrong. Collective. */
int march_step(struct march *m, int whole, const struct march_caller *caller, struct step_status *status);
/* After a step that holds, and the caller's samples of it: every 50 steps, after a step that was made again, and after
 * a refinement, the present state becomes the one to go back to. Collective. */
void march_settle(struct march *m);

/* A run that has become unstable. */
struct march_loss {
    long step;      /* of the last good state, -1: there is none */
    char what[256]; /* what was wrong, where */
    char why[256];  /* which limit of the last good state the step was beyond */
};
/* Puts the last good state back and explains. status: this rank's. Collective. */
struct march_loss march_give_up(struct march *m, struct step_status *status);
