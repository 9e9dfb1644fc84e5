/* Counts the voxels of each material of an image, and the faces between two materials, 64 voxels a word. */
#include "solid/voxels/borders.h"

/* Of 64 voxels, those where two words of solid, at a and b, are of different kinds; b is shifted by `shift` voxels. */
static uint64_t differ(const struct solid_voxels *v, long a, long b, int shift, int is_last) {
    const uint64_t *bits = v->bits;
    uint64_t other = bits[b] >> shift, different = 0;
    if (shift && !is_last) other |= bits[b + 1] << (64 - shift);
    for (int p = 0; p < v->planes; p++) {
        uint64_t kind = v->plane[p][b] >> shift;
        if (shift && !is_last) kind |= v->plane[p][b + 1] << (64 - shift);
        different |= v->plane[p][a] ^ kind;
    }
    return bits[a] & other & different;
}

static uint64_t of_kind(const struct solid_voxels *v, long w, int kind) {
    uint64_t is = v->bits[w];
    for (int p = 0; p < v->planes; p++) is &= kind >> p & 1 ? v->plane[p][w] : ~v->plane[p][w];
    return is;
}

void solid_borders_count(const struct solid_voxels *v, long *count, long faces[3]) {
    const long line = v->words, slice = line * v->n[1];
    for (int c = 0; c < 3; c++) faces[c] = 0;
    for (int q = 0; q < 1 << v->planes; q++) count[q] = 0;
    for (int k = 0; k < v->n[2]; k++)
        for (int j = 0; j < v->n[1]; j++)
            for (long w = solid_voxels_line(v, j, k), end = w + line; w < end; w++) {
                for (int q = 0; q < 1 << v->planes; q++) count[q] += __builtin_popcountll(of_kind(v, w, q));
                faces[0] += __builtin_popcountll(differ(v, w, w, 1, w == end - 1));
                if (j + 1 < v->n[1]) faces[1] += __builtin_popcountll(differ(v, w, w + line, 0, 0));
                if (k + 1 < v->n[2]) faces[2] += __builtin_popcountll(differ(v, w, w + slice, 0, 0));
            }
}
