/* The formats of images: words, and which one a file has. */
#pragma once
#include "base/files/image/source.h"

const char *image_kind_word(enum files_image_format format);
/* By the first bytes, then by the name: s->format, or nonzero with a sentence. */
int image_kind_find(struct image_source *s, const struct files_image_input *input);
