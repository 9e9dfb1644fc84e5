/* The keys of a scene, their types and where they stand in struct scene, as libcyaml reads them. Which keys may be left
 * out is said here; ranges, units and defaults are in scene/rules/rule.h. */
#pragma once
#include "scene/scene.h"

#include <cyaml/cyaml.h>

extern const cyaml_schema_value_t scene_schema; /* of the whole file: a pointer to a struct scene */

/* Loads a text that holds every key it needs; NULL and *why (malloc'ed) where libcyaml refuses it. */
struct scene *scene_schema_load(const char *text, char **why);
void scene_schema_free(struct scene *s);
