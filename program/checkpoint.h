/* The whole state by global index: resumes on any number of ranks.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

/* checkpoint/step_<step>.h5, of which the newest two are kept. Collective. */
void checkpoint_write(struct run *r, const char *folder);
/* checkpoint/stage_<name>.h5, at the end of a stage, kept: other runs may start from it. Collective. */
void checkpoint_write_stage(struct run *r, const char *folder);
/* From a file, or the newest of the folder where file is NULL. Dies with exit code 4 when there is none that can be
 * read, 5 when it does not fit the scene. Leaves the run at the beginning of, or within, the stage it had reached.
 * Collective. */
void checkpoint_read(struct run *r, const char *folder, const char *file);
