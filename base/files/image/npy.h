/* Arrays of numpy (.npy): one of three dimensions, in its order of memory. */
#pragma once
#include "base/files/image/header.h"

int image_npy_open(struct image_source *s, const struct files_image_input *input);
/* Reads the header from memory: n and type of s; nonzero with a sentence. */
int image_npy_parse(struct image_source *s, const char *bytes, size_t n, struct image_header *h);
