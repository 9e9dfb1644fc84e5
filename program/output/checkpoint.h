/* The whole state by global index: can be resumed on any number of ranks.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

enum { CHECKPOINTS_KEPT = 2 };
/* Writes checkpoint/step_<step>.h5; the newest two are kept. Collective. */
void checkpoint_write(struct run *r, const char *folder);
/* Writes checkpoint/stage_<name>.h5 at the end of a stage. It is kept: other runs may start from it. Collective. */
void checkpoint_write_stage(struct run *r, const char *folder);
/* Bytes of a checkpoint of the present state, without HDF5's own. Collective. */
double checkpoint_bytes(struct run *r);
/* Dies with exit code 4 if there is no such file, or no checkpoint in the folder. Collective. */
void checkpoint_require(const char *folder, const char *file);
/* Reads a file, or the newest checkpoint of the folder if file is NULL. Dies with exit code 4 if none can be read, 5 if
 * it does not fit the scene. The run is then at the beginning of, or within, the stage that it had reached.
 * Returns the file's path, which the next call overwrites. Collective. */
const char *checkpoint_read(struct run *r, const char *folder, const char *file);
