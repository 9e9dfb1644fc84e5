/* TIFF: a page a slice, grey or labels, in strips or tiles. */
#pragma once
#include "base/files/image/source.h"

int image_tiff_open(struct image_source *s, const struct files_image_input *input);
