/* MetaImage: a text header (.mhd) beside a raw file, or before the voxels (.mha). */
#pragma once
#include "base/files/image/header.h"

int image_mhd_open(struct image_source *s, const struct files_image_input *input);
/* Reads the header from memory: n, type, voxel and unit of s; nonzero with a sentence. */
int image_mhd_parse(struct image_source *s, const char *text, size_t bytes, struct image_header *h);
