/* The keys of a scene as libcyaml reads them: their types, their members in struct scene, and which may be left out.
 * Ranges, units and defaults are in scene/rules/rule.h. */
#pragma once
#include "scene/scene.h"

#include <cyaml/cyaml.h>

extern const cyaml_schema_value_t scene_schema; /* of the whole file: a pointer to a struct scene */

/* Loads a text that holds all required keys. NULL and *why (malloc'ed) if libcyaml refuses it. */
struct scene *scene_schema_load(const char *text, char **why);
void scene_schema_free(struct scene *s);
