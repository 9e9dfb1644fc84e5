/* frana run and frana check. */
#pragma once
#include "scene/scene.h"
#include "program/command.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
int check_scene(const struct scene *scene);                          /* Collective. */
