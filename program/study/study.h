/* frana study: error against run time of a scene in several variations.  (docs/study.md)
 * Runs as one process, without MPI; it starts the ranks of its runs. What it allocates it keeps until it ends
 * (base/arena.h). */
#pragma once

enum study_task {
    STUDY_ALL,    /* makes the missing runs and writes the report */
    STUDY_LIST,   /* lists the runs, a line each: number, state, ranks, folder */
    STUDY_ONE,    /* makes one run */
    STUDY_COLLECT /* writes the report of the runs that are there */
};

struct study_options {
    const char *file;
    const char *out; /* NULL: results are written beside the study's file */
    int fresh;       /* 1: results of earlier runs are not kept */
    enum study_task task;
    int number; /* of the one run, from 1 */
    /* of a file of gates (docs/study.md) */
    const char *results; /* the folder of summary.csv; NULL: results beside the file */
    int quick;           /* 1: what takes minutes is left out */
};

/* Returns an exit code; of a file of gates 1 if a number misses its tolerance. Mistakes in the file are reported in one
 * sentence each; the program then dies (exit 2). */
int study_run(const struct study_options *o);
