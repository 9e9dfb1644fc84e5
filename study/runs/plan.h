/* The runs of a study: every level by every method, as often as it says, and where each goes. */
#pragma once
#include "study/file/file.h"
#include "study/runs/outcome.h"

/* A method at a level: what its runs share. */
struct study_case {
    int method, level, ranks;
    struct study_sets sets;
    char *resolved; /* the scene that they run, as text */
};

struct study_run {
    int at;       /* index into study_plan's cases */
    int repeat;   /* from 0 */
    char *folder; /* OUT/runs/NAME/METHOD/LEVEL/REPEAT */
    struct study_outcome outcome;
    int kept;      /* 1: it was there already */
    double *value; /* [quantities], NAN: none */
};

struct study_plan {
    const struct study *study; /* borrowed */
    int cases;                 /* [levels][methods] */
    struct study_case *at;
    int runs;              /* [repeats][levels][methods]: what is compared runs in turn */
    struct study_run *run; /* in the order in which they are made */
};

/* Reads the scene with what each case sets; says what is wrong with one of them and dies with exit code 2. */
struct study_plan *study_plan_new(const struct study *study, const char *out);
void study_plan_free(struct study_plan *p);

/* Looks at what the folder of the run holds: keeps it if it is the same scene, ranks and build, and has ended. */
void study_plan_look(const struct study_plan *p, struct study_run *run);
/* Wall seconds, set-up included, that the runs still to do from the first will take, after those that are done: of the
 * same case where there is one, else of the mean; NAN where nothing is known. */
double study_plan_left(const struct study_plan *p, int first);
