/* Numbers for tests that depend on a particle's place in the lattice only. */
#pragma once
#include "solid/solid.h"
#include "solid/state.h"

#include <math.h>
#include <stdint.h>

/* In [-1, 1). */
static inline double noise(const struct solid *s, int h, int c) {
    uint64_t z = (uint64_t)c + 17;
    for (int k = 0; k < s->dim; k++) {
        z = (z ^ (uint64_t)(int64_t)lrint(s->x0[k][h] / s->in.spacing * 2)) * 0x9e3779b97f4a7c15u;
        z ^= z >> 29;
    }
    z *= 0xbf58476d1ce4e5b9u;
    z ^= z >> 32;
    return (double)(z >> 11) * 0x1p-52 - 1;
}
