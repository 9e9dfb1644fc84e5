/* Whether the size of a voxel in an image's header is that of the scene. */
#pragma once
#include "scene/scene.h"

enum { IMAGE_VOXEL_SENTENCE = 700 };

/* Writes a sentence if the header of body b's image names a unit and another size than the scene; returns 1 then, else
 * 0. Reads the header again. Not collective. */
int image_voxel_differs(const struct scene *scene, int b, char sentence[IMAGE_VOXEL_SENTENCE]);
