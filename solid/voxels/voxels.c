/* Makes, frees and counts the bits of an image's solid. */
#include "solid/voxels/voxels.h"
#include "base/ensure.h"
#include "base/memory.h"

#include <string.h>

static size_t words_of(const struct solid_voxels *v) { return (size_t)v->n[2] * (size_t)v->n[1] * (size_t)v->words; }

size_t solid_voxels_bytes(const struct solid_voxels *v) { return words_of(v) * sizeof(uint64_t); }

uint64_t *solid_voxels_array(const struct solid_voxels *v) {
    return memory_new(MEMORY_SOLID, words_of(v), sizeof(uint64_t));
}

struct solid_voxels *solid_voxels_new(const int n[3], const int sites[3], const int corner[3]) {
    struct solid_voxels *v = memory_new(MEMORY_SOLID, 1, sizeof *v);
    memcpy(v->n, n, sizeof v->n);
    memcpy(v->corner, corner, sizeof v->corner);
    for (int c = 0; c < 3; c++) v->sites[c] = sites ? sites[c] : 1;
    v->words = (n[0] + 63) / 64;
    v->shared_bits = par_shared_new(MEMORY_SOLID, solid_voxels_bytes(v));
    v->bits = v->shared_bits->data;
    return v;
}

void solid_voxels_hold(struct solid_voxels *v) {
    v->shared_held = par_shared_new(MEMORY_SOLID, solid_voxels_bytes(v));
    v->held = v->shared_held->data;
}

void solid_voxels_free(struct solid_voxels *v) {
    if (!v) return;
    par_shared_free(v->shared_bits);
    par_shared_free(v->shared_held);
    for (int p = 0; p < v->planes; p++) par_shared_free(v->shared_plane[p]);
    memory_free(v);
}

void solid_voxels_kinds(struct solid_voxels *v, int kinds) {
    for (; kinds > 1 << v->planes; v->planes++) {
        ENSURE(v->planes < SOLID_VOXELS_PLANES, "%d kinds of voxels", kinds);
        v->shared_plane[v->planes] = par_shared_new(MEMORY_SOLID, solid_voxels_bytes(v));
        v->plane[v->planes] = v->shared_plane[v->planes]->data;
    }
}

const char *solid_voxels_why(const struct solid_voxels *v) {
    const char *why = v->shared_bits->why;
    for (int p = 0; p < v->planes && !why[0]; p++) why = v->shared_plane[p]->why;
    return why;
}

long solid_voxels_count(const struct solid_voxels *v, const uint64_t *bits) {
    long sum = 0;
    for (size_t w = 0; w < words_of(v); w++) sum += __builtin_popcountll(bits[w]);
    return sum;
}

void solid_voxels_of(const struct solid_voxels *v, int phase, int j, int k, uint64_t *line) {
    const uint64_t *from = v->bits + solid_voxels_line(v, j, k);
    const uint64_t last = v->n[0] % 64 ? ((uint64_t)1 << v->n[0] % 64) - 1 : ~(uint64_t)0;
    for (long w = 0; w < v->words; w++) line[w] = phase ? from[w] : ~from[w];
    line[v->words - 1] &= last;
}
