/* Of an image of several materials: voxels of each, and borders between them. */
#pragma once
#include "solid/voxels/voxels.h"

/* of [2^planes]: voxels of the solid of each kind. Returns how many faces separate two voxels of different kinds. Not
 * collective. */
long solid_borders_count(const struct solid_voxels *v, long *count);
