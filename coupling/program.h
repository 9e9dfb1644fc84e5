/* frana run and frana check. */
#pragma once
#include "base/scene.h"
#include "coupling/command.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
int program_check(const struct scene *scene);                        /* Collective. */
