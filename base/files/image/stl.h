/* Voxels inside a closed surface of triangles (STL, binary or text): 1 inside, 0 outside. The surface's bounding box is
 * cut into voxels from its low corner on.
 *
 * Corners and centres of voxels are rounded to whole numbers of 2^-29 of the longest edge of the bounding box: corners
 * closer than this are one. With whole numbers all is exact. A centre on the surface counts as a little lower along x,
 * y and z, so a box from a to b has the centres a < x <= b. */
#pragma once
#include "base/files/image/source.h"

/* input->edge is needed. Nonzero with a sentence for a surface that is not closed. */
int image_stl_open(struct image_source *s, const struct files_image_input *input);
