/* Whether an image is a sample whose pores are shut at periodic sides of a flow. */
#pragma once
#include "scene/scene.h"
#include "solid/voxels/voxels.h"

enum { IMAGE_CUT_SENTENCE = 320 };

/* The share of the pores' area at the two periodic sides across an axis that meets pores, if the image fills the domain
 * along it and its pores do not go on there (stokes_mask_share); else NaN. gone: bits of solid that the scene removes;
 * may be NULL. Not collective. */
double image_cut_meets(const struct scene *scene, const struct solid_voxels *v, const uint64_t *gone, int axis);
/* What to think of it. Returns 0 and writes nothing for NaN. Not collective. */
int image_cut_say(double meets, int axis, char sentence[IMAGE_CUT_SENTENCE]);
