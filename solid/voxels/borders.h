/* Of an image of several materials: voxels of each, and borders between them. */
#pragma once
#include "solid/voxels/voxels.h"

/* count [2^planes]: voxels of the solid of each kind. faces: those across x, y and z that separate two voxels of
 * different kinds. Not collective. */
void solid_borders_count(const struct solid_voxels *v, long *count, long faces[3]);
