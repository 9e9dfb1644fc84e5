/* The struts of one wet particle, for the tests. */
#pragma once
#include "cracks/cracks.h"

/* The wet index of the particle or ghost at a place. */
static inline int index_at(const struct cracks_struts *t, int place) {
    const int row = t->rows.row_of[place / CRACKS_LANES];
    int i = row < 0 ? -1 : t->rows.index[row][place % CRACKS_LANES];
    for (int g = t->n; i < 0 && g < t->n + t->ghosts; g++) i = t->place[g] == place ? g : -1;
    return i;
}

/* The struts of wet particle i that are on, with pores the intact bonds too: kind and other end [2 SOLID_FAMILY_MAX],
 * as the wet index of an owned particle or a ghost. NULL: not wanted. Returns how many. For tests and particles where
 * the faces of cracks cancel. Not collective. */
static inline int struts_of(const struct cracks *c, int i, uint16_t *kind, int *other) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    const int row = t->slot[i] / CRACKS_LANES, lane = t->slot[i] % CRACKS_LANES;
    int n = 0;
    for (long k = r->start[row]; k < r->end[row]; k++) {
        if (!(r->strut[k].lanes >> lane & 1)) continue;
        if (kind) kind[n] = r->strut[k].kind;
        if (other) other[n] = index_at(t, r->strut[k].at + lane);
        n++;
    }
    return n;
}
