/* NRRD: a text header before the voxels (.nrrd) or beside their file (.nhdr); raw or compressed by gzip. */
#pragma once
#include "base/files/image/header.h"

int image_nrrd_open(struct image_source *s, const struct files_image_input *input);
/* Reads the header from memory: n, type, voxel and unit of s; nonzero with a sentence. */
int image_nrrd_parse(struct image_source *s, const char *text, size_t bytes, struct image_header *h);
