/* frana run --resume-or-start: the same command starts a run, goes on with it, and does nothing once it is done. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* Sets how `c` goes on by what its run folder holds, which this run locks: c->resume from a checkpoint, c->archives
 * after a run that was killed before its first one. Returns 0 and says so if the run is done. Dies with exit code 4 if
 * the folder holds other files than a run's, or another scene's run without a checkpoint. Collective. */
int resume_or_start(struct command *c, const struct scene *scene);
