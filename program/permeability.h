/* frana permeability. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* Three runs, along x, y and z, and the tensor of permeability from them. Returns the exit code. Collective. */
int permeability_run(const struct command *c, const struct scene *scene);
