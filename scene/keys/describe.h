/* The scene's keys for editors and shells: a JSON Schema, and a list. Both are written from the tables by which scenes
 * are read. Not collective. */
#pragma once
#include <stdio.h>

/* JSON Schema, draft 7: types, ranges, choices, needed keys, and keys that need or exclude a key beside them. What
 * depends on other parts of the scene (a plate's vectors, keys of a scene with a fluid) is in the descriptions only. */
void scene_describe_schema(FILE *to);
/* One line a key of which the path begins so, separated by tabs: path, unit, default ("needed", "none"), range, what.
 * Returns the number of keys. */
int scene_describe_keys(FILE *to, const char *beginning);
/* "spacing (m): distance of the particles": what docs/scene.md says of the key at a path such as solid.spacing or
 * solid.bodies[].shape, in one line; malloc'ed, NULL if there is no such key or nothing is said of it. */
char *scene_describe_key(const char *path);
