/* Parts of the program that a scene leaves out, in sentences. */
#pragma once
#include "scene/scene.h"

enum { LEFT_OUT_MAX = 16, LEFT_OUT_SENTENCE = 160 };
/* Returns the number of sentences. Not collective. */
int left_out_of(const struct scene *scene, char sentence[LEFT_OUT_MAX][LEFT_OUT_SENTENCE]);
