/* The solid of an image: one bit a voxel, in lines along x. With several materials, or kinds, the kind of a voxel takes
 * further bits: bit p is in plane p. Each node holds the whole of them once while a solid is made (base/par_shared.h).
 */
#pragma once
#include "base/par_shared.h"

#include <stdint.h>

enum { SOLID_VOXELS_PLANES = 4 }; /* for SOLID_BODY_MATERIALS_MAX kinds (solid/input.h) */

struct solid_voxels {
    int n[3];       /* voxels along x, y, z */
    int sites[3];   /* lattice sites along the edges of a voxel */
    int corner[3];  /* lattice indices of the first site */
    long words;     /* words of 64 voxels in a line */
    uint64_t *bits; /* [n[2]][n[1]][words] 1: solid; 0 past the end of a line */
    uint64_t *held; /* the same: voxels whose particles are held during the whole run; NULL: none */
    int planes;     /* 0: all voxels are of kind 0 */
    uint64_t *plane[SOLID_VOXELS_PLANES]; /* the same; in solid voxels the bits of the kind */
    struct par_shared *shared_bits, *shared_held, *shared_plane[SOLID_VOXELS_PLANES]; /* which hold them; owned */
};

/* All pore. sites NULL: one. Collective. */
struct solid_voxels *solid_voxels_new(const int n[3], const int sites[3], const int corner[3]);
/* Makes the array of held voxels, all 0. Collective. */
void solid_voxels_hold(struct solid_voxels *v);
/* Makes room for so many kinds; all voxels are of kind 0. Collective. */
void solid_voxels_kinds(struct solid_voxels *v, int kinds);
/* Not collective, as all below. */
void solid_voxels_free(struct solid_voxels *v);             /* may be NULL */
uint64_t *solid_voxels_array(const struct solid_voxels *v); /* of as many bits, all 0; of this rank alone */
size_t solid_voxels_bytes(const struct solid_voxels *v);    /* of the bits; of a plane */
/* What hinders the ranks of a node from sharing the bits or a plane, the same text on all ranks; "": nothing. */
const char *solid_voxels_why(const struct solid_voxels *v);

static inline long solid_voxels_line(const struct solid_voxels *v, int j, int k) {
    return ((long)k * v->n[1] + j) * v->words;
}
static inline int solid_voxels_is(const struct solid_voxels *v, const uint64_t *bits, int i, int j, int k) {
    return (int)(bits[solid_voxels_line(v, j, k) + i / 64] >> i % 64 & 1);
}
/* Sets bits of a word while other ranks of the node may set others. */
static inline void solid_voxels_join(uint64_t *word, uint64_t bits) {
    if (bits) __atomic_fetch_or(word, bits, __ATOMIC_RELAXED);
}
static inline void solid_voxels_set(const struct solid_voxels *v, uint64_t *bits, int i, int j, int k) {
    solid_voxels_join(bits + solid_voxels_line(v, j, k) + i / 64, (uint64_t)1 << i % 64);
}
static inline int solid_voxels_kind(const struct solid_voxels *v, int i, int j, int k) {
    int kind = 0;
    for (int p = 0; p < v->planes; p++) kind |= solid_voxels_is(v, v->plane[p], i, j, k) << p;
    return kind;
}
/* Of a voxel of kind 0 so far. */
static inline void solid_voxels_set_kind(struct solid_voxels *v, int kind, int i, int j, int k) {
    for (int p = 0; p < v->planes; p++)
        if (kind >> p & 1) solid_voxels_set(v, v->plane[p], i, j, k);
}
long solid_voxels_count(const struct solid_voxels *v, const uint64_t *bits);
/* Copies a line of the solid, or with phase = 0 of its pores, to line [words]. */
void solid_voxels_of(const struct solid_voxels *v, int phase, int j, int k, uint64_t *line);
