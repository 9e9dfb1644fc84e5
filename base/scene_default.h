/* Defaults that rest on other keys, and what is worked out from them. */
#pragma once
#include "base/scene_check.h"

/* Spacing of the solid, names and materials of bodies, the medium's box: into the struct and the tree. */
void scene_default_fill(struct scene *s, struct scene_node *root, struct scene_problems *problems);
/* What the struct holds besides the file's keys: indices of materials, directions as numbers, what is periodic. */
void scene_default_derive(struct scene *s, const struct scene_node *root);
