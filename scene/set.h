/* Settings of the command line: --set key.path=value. */
#pragma once
#include "scene/text/problem.h"

/* Puts each setting into the tree. A path may go through a list by index (stages[0].steps, stages.0.steps) or by the
 * name of an entry (stages.flow.steps). Missing sections of the path are added. */
void scene_set(struct scene_node *root, int n, const char *const *set, struct scene_problems *problems);
