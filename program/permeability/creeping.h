/* frana permeability of a rigid sample: creeping flow, solved at once. */
#pragma once
#include "program/command/command.h"
#include "program/permeability/drive.h"

/* The tensor on the scene's grid and on one twice as fine, extrapolated, with the error of the grid. Returns the exit
 * code. Collective. */
int permeability_creeping_run(const struct command *c, const struct scene *scene,
                              const struct permeability_drive *drive);
