/* frana post: derived quantities, PDFs, plots, pictures and a report, from the files of a run.  (docs/post.md)
 * Runs as one process, and writes to the run folder's post/ only. */
#pragma once
#include "postproc/options.h"

/* Reads the run folder and writes RUNDIR/post/. Returns an exit code: EXIT_CODE_FILE, after one sentence, if the folder
 * contains no run or post/ cannot be written. A run that is still going on, was stopped, or lacks some files gives a
 * partial report. */
int postproc_post(const char *rundir, const struct postproc_options *options); /* options NULL: defaults */
/* Writes common curves and the numbers of n runs to the folder out. Returns an exit code. */
int postproc_compare(int n, const char *const *rundir, const char *out);
