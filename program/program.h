/* frana run and frana check. */
#pragma once
#include "program/command.h"
#include "scene/scene.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
int check_scene(const struct scene *scene);                          /* Collective. */
