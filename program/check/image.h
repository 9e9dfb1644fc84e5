/* frana check of the images of a scene. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* Prints what the scene's images hold, and writes pictures of their slices. Returns the particles of the bodies of
 * images. Collective. */
double check_image(const struct command *c, const struct scene *scene);
