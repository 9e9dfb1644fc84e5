/* Reads as many bonds of a list at once as a vec has lanes. For solid/ only. */
#pragma once
#include "base/vec.h"
#include "solid/bonds/list.h"

/* Whether the bonds from j on are intact, bit k for bond j + k: as many as a vec has lanes, in one block. Padding
 * counts as broken. */
static inline unsigned solid_list_lanes_intact(const struct solid_list *list, long j) {
    const unsigned soft = list->soft ? list->soft[j / SOLID_LIST_BLOCK] >> j % SOLID_LIST_BLOCK : 0;
    return (~vec_signs(vec_load(list->stiffness + j)) | soft) & VEC_ALL;
}
/* The same of the block that begins at j. */
static inline unsigned solid_list_lanes_block_intact(const struct solid_list *list, long j) {
    unsigned intact = 0;
    for (int k = 0; k < SOLID_LIST_BLOCK; k += VEC_LANES) intact |= solid_list_lanes_intact(list, j + k) << k;
    return intact;
}

/* X0_l - X0_h along x of the bonds from j on, spacings, as many as a vec has lanes, in one block; along c
 * SOLID_LIST_BLOCK c numbers behind. dim: the list's. */
static inline const float *solid_list_lanes_step(const struct solid_list *list, long j, int dim) {
    const long lane = (int)VEC_LANES < (int)SOLID_LIST_BLOCK ? j & (SOLID_LIST_BLOCK - 1) : 0;
    return list->step + (j - lane) * dim + lane;
}
