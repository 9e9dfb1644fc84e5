/* The hash table of a plan: the particle at a position. For solid/ only. */
#pragma once
#include "solid/refine/plan.h"

/* A coordinate wrapped into the period. */
static inline int solid_refine_places_wrapped(int x, int period) {
    const int r = period ? x % period : x;
    return r < 0 && period ? r + period : r;
}

static inline unsigned long solid_refine_places_hash(int x, int y) {
    unsigned long z = (unsigned long)(uint32_t)x << 32 | (uint32_t)y;
    z = (z ^ z >> 33) * 0xff51afd7ed558ccdu;
    return z ^ z >> 29;
}

/* The particle at a position, also across periodic sides, or -1. */
static inline long solid_refine_places_at(const struct solid_refine_plan *p, int x, int y) {
    x = solid_refine_places_wrapped(x, p->period[0]);
    y = solid_refine_places_wrapped(y, p->period[1]);
    for (unsigned long k = solid_refine_places_hash(x, y);; k++) {
        const long i = p->slot[(long)k & p->mask] - 1;
        if (i < 0 || (p->at[i][0] == x && p->at[i][1] == y)) return i;
    }
}

/* Enters particle i at an empty position. */
static inline void solid_refine_places_enter(struct solid_refine_plan *p, long i) {
    unsigned long k = solid_refine_places_hash(p->at[i][0], p->at[i][1]);
    while (p->slot[(long)k & p->mask]) k++;
    p->slot[(long)k & p->mask] = i + 1;
}
