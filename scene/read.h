/* A scene from its text: what scene_new does on one rank, without leaving on a mistake. Not collective. */
#pragma once
#include "scene/scene.h"
#include "scene/text/problem.h"

/* path: of the file; what it names is looked for relative to its folder, unless look_for_files is 0.
 * NULL where problems were found, which are then sorted by line. */
struct scene *scene_read(const char *path, const char *text, size_t bytes, int n, const char *const *set,
                         int look_for_files, struct scene_problems *problems);
void scene_read_free(struct scene *scene); /* NULL: nothing */
