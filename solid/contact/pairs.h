/* The listed pairs; a pair that touches. For solid/ only. */
#pragma once
#include "solid/bonds/interface.h"
#include "solid/contact/ends.h"

#include <math.h>

/* Not collective. */
void solid_contact_pairs_free(struct solid_contact_pairs *pairs);
void solid_contact_pairs_add(struct solid_contact_pairs *pairs, int h, int l, const double xi[3]);
/* Sorts the pairs by h, of which there are `particles`: near pairs then stand near each other, and in the cache. */
void solid_contact_pairs_order(struct solid_contact_pairs *pairs, int particles);

/* |X0_h - X0_l| of pair k, m. */
static inline double solid_contact_pairs_initial_distance(const struct solid_contact_pairs *p, int k) {
    double r2 = 0;
    for (int c = 0; c < p->dim; c++) r2 += p->xi[c][k] * p->xi[c][k];
    return sqrt(r2);
}

/* A pair that touches. */
struct solid_contact_touch {
    struct solid_contact_end *h, *l;
    double x[3], r; /* X_h - X_l, m; its length, at least 1e-6 r_c to avoid a division by 0 */
    double radius; /* r_c of the pair, m; of two particles of one body, or of bonded ones, at most their distance at the
                    * start: then a bond that breaks, which is longer, creates no energy of contact */
    double k;      /* k_c, N/m6 */
};

static inline struct solid_contact_touch solid_contact_pairs_touch(const struct solid *s, const struct solid_contact *c,
                                                                   int kind, int k) {
    const struct solid_contact_pairs *p = &c->pairs[kind];
    struct solid_contact_end *end = c->ends->end, *h = &end[c->ends->h[kind][k]], *l = &end[c->ends->l[kind][k]];
    struct solid_contact_touch t = {.h = h, .l = l};
    for (int i = 0; i < p->dim; i++) t.x[i] = p->xi[i][k] + (h->d[i] - l->d[i]);
    t.r = fmax(sqrt(t.x[0] * t.x[0] + t.x[1] * t.x[1] + t.x[2] * t.x[2]), 1e-6 * c->radius);
    t.k = s->in.contact_stiffness * 0.5 * (c->c0[h->material] + c->c0[l->material]);
    t.radius = c->radius;
    if (c->starts_near && (h->body == l->body || solid_interface_joins(&s->in, h->body, l->body)))
        t.radius = fmin(t.radius, solid_contact_pairs_initial_distance(p, k));
    if (s->refine) /* r_c of the smaller cell */
        t.radius *= fmin(sqrt(fmin(l->volume, h->volume) / (s->in.spacing * s->in.spacing * s->in.thickness)), 1);
    return t;
}
