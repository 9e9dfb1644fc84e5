/* Reads a scene from its text: the work of scene_new on one rank, which returns after a mistake. Not collective. */
#pragma once
#include "scene/scene.h"
#include "scene/text/problem.h"

/* path: of the file. File names in the scene are relative to its folder; whether these files exist is checked unless
 * look_for_files is 0. Returns NULL if problems were found; these are then sorted by line. */
struct scene *scene_read(const char *path, const char *text, size_t bytes, int n, const char *const *set,
                         int look_for_files, struct scene_problems *problems);
void scene_read_free(struct scene *scene); /* NULL: nothing */
