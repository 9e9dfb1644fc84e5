/* frana study: a scene over variations, its error against its run time.  (docs/study.md) One process, without MPI: it
 * starts the ranks of its runs. */
#pragma once

struct study_options {
    const char *file;
    const char *out; /* NULL: results beside the file */
    int fresh;       /* 1: nothing is kept of what was run before */
};

/* Returns an exit code; dies (exit 2) in one sentence a mistake on a file that it does not understand. */
int study_run(const struct study_options *o);
