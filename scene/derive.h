/* Members of the struct that are not keys of the file: dimension, indices of materials, directions as numbers, periodic
 * directions, curves of outlines, functions of time. */
#pragma once
#include "scene/scene.h"
#include "scene/text/node.h"

void scene_derive_domain(struct scene *s, const struct scene_node *root); /* the dimension; defaults depend on it */
void scene_derive(struct scene *s, const struct scene_node *root);
void scene_derive_free(struct scene *s); /* before the struct itself is freed */
