/* Defaults that are computed from other keys. */
#pragma once
#include "scene/check/check.h"

/* Fills in the solid's spacing, Poisson's ratios, the bodies' names and materials, the stages' integrators and the
 * medium's box, in the struct and in the tree. */
void scene_default_fill(struct scene *s, struct scene_node *root, struct scene_problems *problems);
