/* Markers that are scattered over a box. To be included by one test program. */
#pragma once
#include "base/par.h"
#include "ibm/state.h"

#include <stdint.h>

enum { SCATTERED = 600 };

/* In [0, 1), of two numbers. */
static inline double hash(unsigned n, unsigned c) {
    uint64_t z = (uint64_t)(n * 4 + c + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 29)) * 0xbf58476d1ce4e5b9u;
    return (double)((z ^ (z >> 32)) >> 11) * 0x1p-53;
}

/* SCATTERED markers anywhere in the box, the same ones on any number of ranks, of which each rank hands on every
 * size-th; some stand on the sides. x[3], volume: [SCATTERED]; returns how many are this rank's. */
static inline int scattered(const struct fluid_grid *g, double (*x)[SCATTERED], double *volume) {
    int n = 0;
    for (unsigned h = (unsigned)par_rank(); h < SCATTERED; h += (unsigned)par_size(), n++)
        for (int d = 0; d < 3; d++) {
            const double part = hash(h, (unsigned)d);
            x[d][n] = g->length[d] * (h % 10 == 0 && (int)(h / 10 % 3) == d ? h / 30 % 2 : part);
            volume[n] = g->d[0] * g->d[1] * g->d[2];
        }
    return n;
}
