/* frana run of a scene that is stepped. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
