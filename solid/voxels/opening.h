/* The thin parts of an image's solid or pores, by opening: a voxel is thick if some box of edge voxels that holds it
 * lies wholly in the phase and in the image. */
#pragma once
#include "solid/voxels/voxels.h"

/* Voxels of the solid (phase = 1) or of the pores (0) that no such box holds. Takes 2 edge[2] slices of bits. Not
 * collective. */
long solid_opening_thin(const struct solid_voxels *v, int phase, const int edge[3]);
