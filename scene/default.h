/* Defaults that rest on other keys. */
#pragma once
#include "scene/check/check.h"

/* Spacing of the solid, Poisson's ratios, names and materials of bodies, the medium's box: into the struct and the
 * tree. */
void scene_default_fill(struct scene *s, struct scene_node *root, struct scene_problems *problems);
