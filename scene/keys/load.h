/* Loads a tree whose keys have been checked into struct scene, by the tables of keys. Not collective. */
#pragma once
#include "scene/scene.h"
#include "scene/text/node.h"

struct scene *scene_load(const struct scene_node *root);
void scene_load_free(struct scene *s);
