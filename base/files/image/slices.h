/* A folder of slices: TIFFs of one page each, whose names differ by a number alone. */
#pragma once
#include "base/files/image/source.h"

/* Whether a path is a folder. */
int image_slices_are(const char *path);
/* The slices in the order of their numbers, which must follow one another. Other files of the folder are left alone. */
int image_slices_open(struct image_source *s, const struct files_image_input *input);
