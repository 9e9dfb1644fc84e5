/* The runs of a study: every level by every method, with its repeats, and the folder of each run. */
#pragma once
#include "program/study/file/file.h"
#include "program/study/runs/outcome.h"

/* A method at a level: the data common to its repeats. */
struct study_case {
    int method, level, ranks;
    struct study_sets sets;
    char *resolved; /* the scene of its runs, as text */
};

struct study_run {
    int at;         /* index into study_plan's cases */
    int repeat;     /* from 0 */
    char *member;   /* the setting of an ensemble's run, borrowed; NULL: none */
    char *resolved; /* the scene, as text: its case's, or its own in an ensemble */
    char *folder;   /* OUT/runs/NAME/METHOD/LEVEL/REPEAT */
    struct study_outcome outcome;
    int reused;    /* 1: the run existed already and is used again */
    double *value; /* [quantities], NAN: none */
};

struct study_plan {
    const struct study *study; /* borrowed */
    int cases;                 /* [levels][methods] */
    struct study_case *at;
    int runs;              /* [repeats][levels][methods]: runs to be compared follow one another */
    struct study_run *run; /* in the order in which they are run */
};

/* Reads the scene with the settings of each case. Reports the mistakes of a case and dies with exit code 2. */
struct study_plan *study_plan_new(const struct study *study, const char *out);

/* Reads the run's folder. The run is used again if its scene, ranks and build are the same and if it has ended. */
void study_plan_read(const struct study_plan *p, struct study_run *run);
/* Whether the run's folder holds the same run, by the same build, stopped at a checkpoint. */
int study_plan_goes_on(const struct study_plan *p, const struct study_run *run);
/* Wall time, s, with set-up, that the remaining runs from the first on will take: estimated from finished runs of the
 * same case, else from the mean of all; NAN without finished runs. */
double study_plan_left(const struct study_plan *p, int first);
