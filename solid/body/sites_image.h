/* The lattice sites of a body that is cut from an image. For solid/ only. */
#pragma once
#include "solid/body/sites.h"

struct solid_voxels;

/* Sets low, rows, bits, count and base of the sites whose centres are in the solid's voxels, and top, the highest
 * lattice indices. Rows are aligned as for other shapes, so that they are the fewest. Collective. */
void solid_sites_image(const struct solid_voxels *v, struct solid_sites *sites, int top[3]);
/* Whether a site belongs to a voxel whose bit is set in bits. */
int solid_sites_image_is(const struct solid_voxels *v, const uint64_t *bits, const int site[3]);
/* The kind of the voxel of a site of the solid. */
int solid_sites_image_kind(const struct solid_voxels *v, const int site[3]);
