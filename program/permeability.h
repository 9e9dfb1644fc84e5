/* frana permeability. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* The tensor of permeability, of creeping flow through a rigid sample or by three runs that are stepped in time.
 * Returns the exit code. Collective. */
int permeability_run(const struct command *c, const struct scene *scene);
