/* Voxels one after the other in a file: a raw file, or the data of a MetaImage or NRRD. */
#pragma once
#include "base/files/image/source.h"

enum { IMAGE_RAW_AT_END = -1 };

/* Opens `path`, whose voxels follow `skip` bytes, or are its last bytes (IMAGE_RAW_AT_END); s->n and s->type say how
 * many they are. The file must end with them. Nonzero with a sentence. */
int image_raw_open(struct image_source *s, const char *path, long long skip, enum files_image_order order);
