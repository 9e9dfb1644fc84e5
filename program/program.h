/* frana run, frana check and frana permeability. */
#pragma once
#include "program/command.h"
#include "scene/scene.h"

int program_run(const struct command *c, const struct scene *scene); /* the exit code. Collective. */
/* Three runs, along x, y and z, and the tensor of permeability from them. Returns the exit code. Collective. */
int permeability_run(const struct command *c, const struct scene *scene);
int check_scene(const struct command *c, const struct scene *scene); /* Collective. */
/* Prints what the scene's images hold, and writes pictures of their slices. Returns the particles of the bodies of
 * images. Collective. */
double check_image(const struct command *c, const struct scene *scene);
