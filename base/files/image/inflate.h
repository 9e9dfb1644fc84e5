/* Voxels one after the other in a file that gzip or zlib compressed. */
#pragma once
#include "base/files/image/source.h"

/* The compressed bytes begin at `at`; `skip` of the uncompressed ones come before the voxels. Nonzero with a sentence.
 */
int image_inflate_open(struct image_source *s, const char *path, long long at, long long skip,
                       enum files_image_order order);
