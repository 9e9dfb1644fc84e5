/* Whether an image is a sample whose pores are shut at periodic sides of a flow. */
#pragma once
#include "scene/scene.h"
#include "solid/voxels/voxels.h"

enum { IMAGE_CUT_SENTENCE = 320 };

/* The share of the pores' area at the two periodic sides across an axis that is pore on both sides, if the image fills
 * the domain along the axis and its pores do not continue there (stokes_mask_overlap_share); else NaN. gone: bits of
 * solid that the scene removes, may be NULL. Not collective. */
double image_cut_share(const struct scene *scene, const struct solid_voxels *v, const uint64_t *gone, int axis);
/* Writes what the share means for the permeability. Returns 0 and writes nothing for NaN. Not collective. */
int image_cut_describe(double share, int axis, char sentence[IMAGE_CUT_SENTENCE]);
