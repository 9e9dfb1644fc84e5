/* Connected pieces of an image's solid or pores: voxels that share a face are connected. Found slice by slice from runs
 * of voxels along x; in memory stand two slices of runs and 13 bytes for every label that a run began. */
#pragma once
#include "solid/voxels/voxels.h"

struct solid_components {
    int phase;                    /* 1: of the solid, 0: of the pores */
    long voxels, pieces, largest; /* voxels of all pieces; how many pieces; voxels of the largest */
    long through[3];              /* voxels of pieces that reach both ends of the image along x, y, z */
    /* pieces other than the largest, and without a voxel in the boxes */
    long floating_pieces, floating_voxels, floating_largest;
    /* by label, the order in which pieces begin */
    uint32_t labels, capacity, *parent;
    long *size;
    uint8_t *mark;
};

/* wraps: directions in which the ends of the image touch. box [boxes][2]: voxels low <= i < high. Not collective. */
struct solid_components *solid_components_new(const struct solid_voxels *v, int phase, const int wraps[3], int boxes,
                                              const int (*box)[2][3]);
void solid_components_free(struct solid_components *c); /* may be NULL */
/* Sets the bits of the loose pieces' voxels in an array of solid_voxels_array. */
void solid_components_floating(const struct solid_components *c, const struct solid_voxels *v, uint64_t *bits);
