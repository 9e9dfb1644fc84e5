/* frana post: derived quantities, PDFs, plots, pictures and a report, from what a run wrote.  (docs/post.md)
 * One process; nothing of the run folder but its post/ is touched. */
#pragma once
#include "postproc/options.h"

/* Reads the run folder and writes RUNDIR/post/. Returns an exit code: EXIT_CODE_FILE, after one sentence, when the
 * folder holds no run or post/ cannot be written. A run that is still going on, was stopped, or lacks parts gives what
 * there is. */
int postproc_post(const char *rundir, const struct postproc_options *options); /* options NULL: nothing special */
/* The curves and numbers of n runs over one another, in the folder out. Returns an exit code. */
int postproc_compare(int n, const char *const *rundir, const char *out);
