/* Position of a lattice brick along the Hilbert curve, the key by which particles are numbered. */
#include "solid/geometry/curve.h"

/* Skilling (2004), Programming the Hilbert curve: the excess rotations are undone from the top bit down, then the words
 * are Gray-encoded; the bits of the words, interleaved, are the position. */
uint64_t solid_curve_key(const uint32_t *brick, int dim) {
    uint32_t x[3] = {brick[0], brick[1], dim > 2 ? brick[2] : 0};
    for (uint32_t bit = 1u << (SOLID_CURVE_BITS - 1); bit > 1; bit >>= 1) {
        const uint32_t below = bit - 1;
        for (int c = 0; c < dim; c++) {
            if (x[c] & bit) {
                x[0] ^= below;
            } else {
                const uint32_t differ = (x[0] ^ x[c]) & below;
                x[0] ^= differ;
                x[c] ^= differ;
            }
        }
    }
    for (int c = 1; c < dim; c++) x[c] ^= x[c - 1];
    uint32_t flip = 0;
    for (uint32_t bit = 1u << (SOLID_CURVE_BITS - 1); bit > 1; bit >>= 1)
        if (x[dim - 1] & bit) flip ^= bit - 1;
    uint64_t key = 0;
    for (int b = SOLID_CURVE_BITS - 1; b >= 0; b--)
        for (int c = 0; c < dim; c++) key = key << 1 | (((x[c] ^ flip) >> b) & 1);
    return key;
}
