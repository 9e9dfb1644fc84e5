/* Accelerations by the pairs that touch, a vec of pairs at a time. */
#include "solid/contact/touching.h"
#include "base/vec_shuffle.h"
#include "solid/contact/list.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/room.h"

#include <string.h>

void solid_contact_touching_add(struct solid_contact_touching *t, const struct solid_contact_one *pair) {
    const int b = t->pairs / VEC_LANES, k = t->pairs % VEC_LANES;
    t->block = solid_contact_room(t->block, &t->room, b + 1, sizeof *t->block);
    struct solid_contact_block *to = &t->block[b];
    if (k == 0) {
        memset(to, 0, sizeof *to);
        for (int lane = 0; lane < VEC_LANES; lane++) { /* far apart */
            to->xi[0][lane] = to->start[0][lane] = 2 * pair->radius;
            to->depth[lane] = -1;
            to->radius[lane] = pair->radius;
        }
    }
    for (int i = 0; i < 3; i++) {
        to->xi[i][k] = pair->xi[i];
        to->start[i][k] = pair->start[i];
    }
    to->depth[k] = pair->depth;
    to->radius[k] = pair->radius;
    to->on_h[k] = pair->on_h;
    to->on_l[k] = pair->on_l;
    to->h[k] = pair->h;
    to->l[k] = pair->l;
    t->pairs++;
}

/* Coefficients of the potential's series, c_k of q^k from k = 2 on (solid/contact/repulsion.h). */
struct series {
    double of[SOLID_REPULSION_TERMS];
};

static struct series series_of(double exponent) {
    struct series c = {.of = {0.5 * exponent}};
    for (int k = 0; k + 1 < SOLID_REPULSION_TERMS; k++) c.of[k + 1] = c.of[k] * (exponent + k + 1) / (k + 3);
    return c;
}

/* (phi(a) - phi(b))/(a - b)/r_c of shallow depths a, b >= 0, as solid_repulsion_quotient. */
static vec quotient(vec a, vec b, const struct series *c) {
    enum { FEW = 5 };
    const vec small = vec_set(1e-3) - (a + b);
    vec sums = a + b, power = a, few = c->of[0] * sums;
    for (int k = 1; k < FEW; k++) {
        power *= a;
        sums = power + b * sums;
        few += c->of[k] * sums;
    }
    if (!vec_signs(small)) return few;
    vec all = few;
    for (int k = FEW; k < SOLID_REPULSION_TERMS; k++) {
        power *= a;
        sums = power + b * sums;
        all += c->of[k] * sums;
    }
    return vec_choose(small >= 0, few, all);
}

/* solid_repulsion_slope of lanes that are deep. */
static vec slope_deep(vec slope, unsigned deep, const struct solid_contact_block *p, vec depth, double exponent) {
    for (; deep; deep &= deep - 1) {
        const int k = __builtin_ctz(deep);
        const double potential = solid_repulsion_potential(p->depth[k], p->radius[k], exponent);
        slope[k] = solid_repulsion_slope(p->depth[k], potential, depth[k], p->radius[k], exponent);
    }
    return slope;
}

/* solid_repulsion_slope, end2 the square of the distance at the end. */
static vec slope_of(const struct solid_contact_block *p, vec end2, const struct solid_contact_law *law,
                    const struct series *c) {
    const vec radius = vec_load(p->radius), before = vec_load(p->depth), zero = vec_set(0);
    const vec depth = (radius * radius - end2) * vec_reciprocal(radius * (radius + vec_sqrt(end2)));
    const vec a = vec_max(depth, zero), b = vec_max(before, zero);
    const vec_mask both = (depth > 0) & (before > 0), none = (depth <= 0) & (before <= 0);
    /* of a pair that touches at one end of the motion only, phi changes over a part of the way */
    const vec touched = vec_choose(both, vec_set(1), a - b), way = vec_choose(both | none, vec_set(1), depth - before);
    const vec slope = quotient(a, b, c) * touched * vec_reciprocal(way * (radius * (2 - depth - before)));
    const unsigned deep = vec_signs(SOLID_REPULSION_SHALLOW - vec_max(a, b));
    return deep ? slope_deep(slope, deep, p, depth, law->exponent) : slope;
}

static vec rounded(vec x, double quantum) {
    const double magic = 0x1.8p52 * quantum;
    return (x + magic) - magic;
}

void solid_contact_touching_push(const struct solid_contact_touching *t, const struct solid_contact_law *law,
                                 const double (*now)[4], double (*push)[4]) {
    const struct series c = series_of(law->exponent);
    for (int from = 0; from < t->pairs; from += VEC_LANES) {
        const struct solid_contact_block *p = &t->block[from / VEC_LANES];
        vec of_h[4], of_l[4], end[3], on_h[4] = {0}, on_l[4] = {0}, end2 = vec_set(0);
        vec_shuffle_gather4(now[0], 4, p->h, of_h);
        vec_shuffle_gather4(now[0], 4, p->l, of_l);
        for (int i = 0; i < 3; i++) {
            end[i] = vec_load(p->xi[i]) + (of_h[i] - of_l[i]);
            end2 += end[i] * end[i];
        }
        const vec slope = slope_of(p, vec_max(end2, vec_set(law->least2)), law, &c);
        for (int i = 0; i < 3; i++) {
            const vec along = slope * (vec_load(p->start[i]) + end[i]);
            on_h[i] = rounded(vec_load(p->on_h) * along, law->quantum);
            on_l[i] = rounded(vec_load(p->on_l) * along, law->quantum);
        }
        double to_h[VEC_LANES][4], to_l[VEC_LANES][4];
        vec_shuffle_store4(to_h[0], on_h);
        vec_shuffle_store4(to_l[0], on_l);
        for (int k = 0; k < VEC_LANES; k++) {
            for (int i = 0; i < 4; i++) push[p->h[k]][i] += to_h[k][i];
            for (int i = 0; i < 4; i++) push[p->l[k]][i] -= to_l[k][i];
        }
    }
}
