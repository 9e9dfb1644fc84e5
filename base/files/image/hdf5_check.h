/* What can be checked of an HDF5 file by plain reading, before HDF5 opens it. */
#pragma once
#include "base/files/image/source.h"

/* Finds the superblock: its version, the sizes of addresses, the end of the file and the place of the root group must
 * be possible in a file of so many bytes. Nonzero with a sentence. */
int image_hdf5_check(struct image_source *s, int fd, long long bytes);
