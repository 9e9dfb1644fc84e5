/* Moves lanes between vectors, by shuffles of two vectors each. */
#pragma once
#include "base/vec.h"

/* Shifts by one lane: lane k of the result is lane k+1 of here; lane 7 is the first lane of next. */
static inline vec vec_shuffle_after(vec here, vec next) {
    return __builtin_shufflevector(here, next, 1, 2, 3, 4, 5, 6, 7, 8);
}

/* Lane l of v[k] becomes lane k of v[l]. */
static inline __attribute__((always_inline)) void vec_shuffle_transpose(vec v[VEC_LANES]) {
    vec lane[VEC_LANES], pair[VEC_LANES];
    for (int k = 0; k < 8; k += 2) { /* lanes 0 2 4 6 of two vectors; lanes 1 3 5 7 */
        lane[k] = __builtin_shufflevector(v[k], v[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        lane[k + 1] = __builtin_shufflevector(v[k], v[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int odd = 0; odd < 2; odd++)
        for (int k = 0; k < 8; k += 4) { /* lanes 0 and 4 of four vectors; lanes 2 and 6 */
            pair[k + odd] = __builtin_shufflevector(lane[k + odd], lane[k + odd + 2], 0, 1, 4, 5, 8, 9, 12, 13);
            pair[k + odd + 2] = __builtin_shufflevector(lane[k + odd], lane[k + odd + 2], 2, 3, 6, 7, 10, 11, 14, 15);
        }
    for (int l = 0; l < 4; l++) {
        v[l] = __builtin_shufflevector(pair[l], pair[l + 4], 0, 1, 4, 5, 8, 9, 12, 13);
        v[l + 4] = __builtin_shufflevector(pair[l], pair[l + 4], 2, 3, 6, 7, 10, 11, 14, 15);
    }
}

#undef VEC_TWO
