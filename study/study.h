/* frana study: error against run time of a scene in several variations.  (docs/study.md)
 * Runs as one process, without MPI; it starts the ranks of its runs. */
#pragma once

struct study_options {
    const char *file;
    const char *out; /* NULL: results are written beside the study's file */
    int fresh;       /* 1: results of earlier runs are not kept */
};

/* Returns an exit code. Mistakes in the file are reported in one sentence each; the program then dies (exit 2). */
int study_run(const struct study_options *o);
