/* The loop over the listed pairs that touch now. For solid/ only. */
#pragma once
#include "base/vec.h"
#include "solid/bonds/across.h"
#include "solid/contact/list.h"

#include <math.h>

/* Not collective. */
void solid_contact_pairs_free(struct solid_contact_pairs *pairs);
void solid_contact_pairs_add(struct solid_contact_pairs *pairs, int h, int l, const double xi[3]);
/* Sorts the pairs by h, of which there are `particles`: near pairs then stand near each other, and in the cache. */
void solid_contact_pairs_order(struct solid_contact_pairs *pairs, int particles);

enum { SOLID_CONTACT_BLOCK = 256 };

/* The displacements of the second ends of one kind of pairs. */
static inline double *const *solid_contact_pairs_other_d(const struct solid *s, const struct solid_contact *c,
                                                         int kind) {
    return kind == SOLID_CONTACT_SERVED ? c->crossing.d : s->d;
}

/* Present X_h - X_l of pair k, m. */
static inline void solid_contact_pairs_x(const struct solid_contact_pairs *p, double *const d[3],
                                         double *const d_other[3], int k, double x[3]) {
    x[2] = 0;
    for (int c = 0; c < p->dim; c++) x[c] = p->xi[c][k] + (d[c][p->h[k]] - d_other[c][p->l[k]]);
}

/* The numbers of eight particles. Single loads are faster than the machine's gather. */
static inline vec solid_contact_pairs_of(const double *d, const int *at) {
    return (vec){d[at[0]], d[at[1]], d[at[2]], d[at[3]], d[at[4]], d[at[5]], d[at[6]], d[at[7]]};
}

/* Finds those of the pairs from .. from + SOLID_CONTACT_BLOCK - 1 that are nearer than reach. Returns how many. All
 * distances are computed first, which is most of the work, then the few near pairs are selected. */
static inline int solid_contact_pairs_touching(const struct solid_contact_pairs *p, double *const d[3],
                                               double *const d_other[3], int from, double reach,
                                               int found[SOLID_CONTACT_BLOCK]) {
    const int to = p->n - from < SOLID_CONTACT_BLOCK ? p->n : from + SOLID_CONTACT_BLOCK;
    const vec reach2 = vec_set(reach * reach);
    int touching = 0, k = from;
    for (; k + VEC_LANES <= to; k += VEC_LANES) {
        vec r2 = vec_set(0);
        for (int c = 0; c < p->dim; c++) {
            const vec x = vec_load(p->xi[c] + k) +
                          (solid_contact_pairs_of(d[c], p->h + k) - solid_contact_pairs_of(d_other[c], p->l + k));
            r2 += x * x;
        }
        for (unsigned near = vec_signs(r2 - reach2); near; near &= near - 1)
            found[touching++] = k + __builtin_ctz(near);
    }
    for (; k < to; k++) {
        double x[3];
        solid_contact_pairs_x(p, d, d_other, k, x);
        if (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < reach * reach) found[touching++] = k;
    }
    return touching;
}

/* Body, material and volume of the other end. */
static inline int solid_contact_pairs_other_body(const struct solid *s, const struct solid_contact *c, int kind,
                                                 int l) {
    return kind == SOLID_CONTACT_SERVED ? c->crossing.other[l].body : s->body[l];
}

static inline int solid_contact_pairs_other_material(const struct solid *s, const struct solid_contact *c, int kind,
                                                     int l) {
    return kind == SOLID_CONTACT_SERVED ? c->crossing.other[l].material : solid_made_of(s, l);
}

static inline double solid_contact_pairs_other_volume(const struct solid *s, const struct solid_contact *c, int kind,
                                                      int l) {
    return kind == SOLID_CONTACT_SERVED ? c->crossing.other[l].volume : s->volume[l];
}

/* |X0_h - X0_l| of pair k, m. */
static inline double solid_contact_pairs_start(const struct solid_contact_pairs *p, int k) {
    double r2 = 0;
    for (int c = 0; c < p->dim; c++) r2 += p->xi[c][k] * p->xi[c][k];
    return sqrt(r2);
}

/* A pair that touches. */
struct solid_contact_touch {
    int h, l;
    double x[3], r; /* X_h - X_l, m; its length, at least 1e-6 r_c to avoid a division by 0 */
    double radius; /* r_c of the pair, m; of two particles of one body, or of bonded ones, at most their distance at the
                    * start: then a bond that breaks, which is longer, creates no energy of contact */
    double k;      /* k_c, N/m6 */
    double volume, density; /* of the other end, m3, kg/m3 */
};

static inline struct solid_contact_touch solid_contact_pairs_touch_of(const struct solid *s,
                                                                      const struct solid_contact *c, int kind, int k) {
    const struct solid_contact_pairs *p = &c->pairs[kind];
    struct solid_contact_touch t = {.h = p->h[k], .l = p->l[k]};
    const int body = solid_contact_pairs_other_body(s, c, kind, t.l),
              material = solid_contact_pairs_other_material(s, c, kind, t.l);
    solid_contact_pairs_x(p, s->d, solid_contact_pairs_other_d(s, c, kind), k, t.x);
    t.r = fmax(sqrt(t.x[0] * t.x[0] + t.x[1] * t.x[1] + t.x[2] * t.x[2]), 1e-6 * c->radius);
    t.k = s->in.contact_stiffness * 0.5 * (c->c0[solid_made_of(s, t.h)] + c->c0[material]);
    t.volume = solid_contact_pairs_other_volume(s, c, kind, t.l);
    t.density = c->density[material];
    t.radius = c->radius;
    if (c->begins_near && (s->body[t.h] == body || solid_across_joins(&s->in, s->body[t.h], body)))
        t.radius = fmin(t.radius, solid_contact_pairs_start(p, k));
    if (s->refine) /* r_c of the smaller cell */
        t.radius *= fmin(sqrt(fmin(t.volume, s->volume[t.h]) / (s->in.spacing * s->in.spacing * s->in.thickness)), 1);
    return t;
}
