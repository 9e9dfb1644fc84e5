/* What the struct holds besides the file's keys: dimension, indices of materials, directions as numbers, what is
 * periodic, curves of outlines, functions of time. */
#pragma once
#include "scene/scene.h"
#include "scene/text/node.h"

void scene_derive_domain(struct scene *s, const struct scene_node *root); /* the dimension, which defaults rest on */
void scene_derive(struct scene *s, const struct scene_node *root);
void scene_derive_free(struct scene *s); /* before the struct itself is freed */
