/* frana run and frana check. */
#pragma once
#include "program/command.h"
#include "scene/scene.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
int check_scene(const struct command *c, const struct scene *scene); /* Collective. */
/* Prints what the scene's images hold, and writes pictures of their slices. Returns the particles of the bodies of
 * images. Collective. */
double check_image(const struct command *c, const struct scene *scene);
