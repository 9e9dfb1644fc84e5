/* frana study: error against run time of a scene in several variations.  (docs/study.md)
 * Runs as one process, without MPI; it starts the ranks of its runs. */
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
};

/* Returns an exit code. Mistakes in the file are reported in one sentence each; the program then dies (exit 2). */
int study_run(const struct study_options *o);
