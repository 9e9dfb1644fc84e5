/* frana permeability by time steps. */
#pragma once
#include "program/command/command.h"
#include "program/permeability/drive.h"

/* Three runs, along x, y and z, and the tensor of permeability from them. Returns the exit code. Collective. */
int permeability_stepped_run(const struct command *c, const struct scene *scene,
                             const struct permeability_drive *drive);
