/* frana check of a scene that is stepped. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

int check_scene(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
