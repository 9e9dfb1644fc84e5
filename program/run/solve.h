/* frana run and frana check of scenes that are solved at once (meshless/problem/problem.h). */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

int solve_is(const struct scene *scene); /* Not collective. */
/* The exit code. Collective. */
int solve_run(const struct command *c, const struct scene *scene);
int solve_check(const struct scene *scene);
