/* The loop over the listed pairs that touch now. For solid/ only. */
#pragma once
#include "base/vec_shuffle.h"
#include "solid/contact/pairs.h"

enum { SOLID_CONTACT_BLOCK = 256 };

/* Finds those of the pairs from .. from + SOLID_CONTACT_BLOCK - 1 that are nearer than reach, with the ends' present
 * displacements. Returns how many. All distances are computed first, which is most of the work, then the few near pairs
 * are selected. */
static inline int solid_contact_pairs_touching(const struct solid_contact *c, int kind, int from, double reach,
                                               int found[SOLID_CONTACT_BLOCK]) {
    const struct solid_contact_pairs *p = &c->pairs[kind];
    const int to = p->n - from < SOLID_CONTACT_BLOCK ? p->n : from + SOLID_CONTACT_BLOCK;
    const double *d = c->ends->end[0].d;
    const vec reach2 = vec_set(reach * reach);
    int touching = 0;
    for (int k = from; k < to; k += VEC_LANES) {
        const unsigned all = vec_first(to - k);
        vec between[4], r2 = vec_set(0);
        vec_shuffle_between4(d, SOLID_CONTACT_END_DOUBLES, c->ends->h[kind] + k, c->ends->l[kind] + k, between);
        for (int i = 0; i < p->dim; i++) {
            const vec x = vec_load(p->xi[i] + k) + between[i];
            r2 += x * x;
        }
        for (unsigned near = all & vec_signs(r2 - reach2); near; near &= near - 1)
            found[touching++] = k + __builtin_ctz(near);
    }
    return touching;
}
