/* HDF5: a dataset of three dimensions, [z][y][x] unless the axes are given otherwise; chunked or compressed too. */
#pragma once
#include "base/files/image/source.h"

int image_hdf5_open(struct image_source *s, const struct files_image_input *input);
