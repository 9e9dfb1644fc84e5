/* Accelerations by the pairs that touch, a vec of pairs at a time. */
#include "solid/contact/touching.h"
#include "base/memory.h"
#include "base/vec_shuffle.h"
#include "solid/contact/list.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/reserve.h"

#include <string.h>

/* Room for a vec of pairs more, and another one beyond them. */
static void reserve(struct solid_contact_touching *t) {
    const int n = t->pairs + 2 * VEC_LANES;
    if (n <= t->capacity) return;
    int capacity = t->capacity;
    for (int k = 0; k < SOLID_CONTACT_NUMBERS; k++) {
        capacity = t->capacity;
        t->number[k] = solid_contact_reserve(t->number[k], &capacity, n, sizeof *t->number[k]);
    }
    capacity = t->capacity;
    t->h = solid_contact_reserve(t->h, &capacity, n, sizeof *t->h);
    t->l = solid_contact_reserve(t->l, &t->capacity, n, sizeof *t->l);
}

void solid_contact_touching_free(struct solid_contact_touching *t) {
    for (int k = 0; k < SOLID_CONTACT_NUMBERS; k++) memory_free(t->number[k]);
    MEMORY_FREE(t->h, t->l);
}

void solid_contact_touching_fill_up(struct solid_contact_touching *t) {
    if (t->capacity == 0) return; /* no pair has ever touched */
    struct solid_contact_lanes none = {.depth = vec_set(-1), .radius = vec_set(1)};
    for (int i = 0; i < 3; i++) none.xi[i] = none.start[i] = vec_set(2);
    for (int k = 0; k < SOLID_CONTACT_NUMBERS; k++) {
        vec number;
        memcpy(&number, (const char *)&none + sizeof number * (size_t)k, sizeof number);
        vec_store(t->number[k] + t->pairs, number);
    }
    memset(t->h + t->pairs, 0, VEC_LANES * sizeof *t->h);
    memset(t->l + t->pairs, 0, VEC_LANES * sizeof *t->l);
}

void solid_contact_touching_add(struct solid_contact_touching *t, const struct solid_contact_lanes *some,
                                unsigned which, const int *h, const int *l) {
    const int more = __builtin_popcount(which);
    reserve(t);
    for (int k = 0; k < SOLID_CONTACT_NUMBERS; k++) {
        vec number;
        memcpy(&number, (const char *)some + sizeof number * (size_t)k, sizeof number);
        vec_compress(which, number, t->number[k] + t->pairs);
    }
    memcpy(t->h + t->pairs, h, (size_t)more * sizeof *h);
    memcpy(t->l + t->pairs, l, (size_t)more * sizeof *l);
    t->pairs += more;
}

/* Coefficients of the potential's series, c_k of q^k from k = 2 on (solid/contact/repulsion.h). */
struct series {
    double coefficient[SOLID_REPULSION_TERMS];
};

static struct series series_of(double exponent) {
    struct series c = {.coefficient = {0.5 * exponent}};
    for (int k = 0; k + 1 < SOLID_REPULSION_TERMS; k++)
        c.coefficient[k + 1] = c.coefficient[k] * (exponent + k + 1) / (k + 3);
    return c;
}

/* (phi(a) - phi(b))/(a - b)/r_c of shallow depths a, b >= 0, as solid_repulsion_quotient. */
static vec quotient(vec a, vec b, const struct series *c) {
    enum { FEW = 5 };
    const vec small = vec_set(1e-3) - (a + b);
    vec sums = a + b, power = a, few = c->coefficient[0] * sums;
    for (int k = 1; k < FEW; k++) {
        power *= a;
        sums = power + b * sums;
        few += c->coefficient[k] * sums;
    }
    if (!vec_signs(small)) return few;
    vec all = few;
    for (int k = FEW; k < SOLID_REPULSION_TERMS; k++) {
        power *= a;
        sums = power + b * sums;
        all += c->coefficient[k] * sums;
    }
    return vec_choose(small >= 0, few, all);
}

static struct solid_contact_lanes some_of(const struct solid_contact_touching *t, int from) {
    struct solid_contact_lanes some;
    for (int k = 0; k < SOLID_CONTACT_NUMBERS; k++)
        memcpy((char *)&some + sizeof(vec) * (size_t)k, t->number[k] + from, sizeof(vec));
    return some;
}

/* solid_repulsion_slope of lanes that are deep. */
static vec slope_deep(vec slope, unsigned deep, const struct solid_contact_lanes *p, vec depth, double exponent) {
    for (; deep; deep &= deep - 1) {
        const int k = __builtin_ctz(deep);
        const double potential = solid_repulsion_potential(p->depth[k], p->radius[k], exponent);
        slope[k] = solid_repulsion_slope(p->depth[k], potential, depth[k], p->radius[k], exponent);
    }
    return slope;
}

/* solid_repulsion_slope, end2 the square of the distance at the end. */
static vec slope_of(const struct solid_contact_lanes *p, vec end2, const struct solid_contact_law *law,
                    const struct series *c) {
    const vec radius = p->radius, before = p->depth, zero = vec_set(0);
    const vec depth = (radius * radius - end2) * vec_reciprocal(radius * (radius + vec_sqrt(end2)));
    const vec a = vec_max(depth, zero), b = vec_max(before, zero);
    const vec_mask both = (depth > 0) & (before > 0), none = (depth <= 0) & (before <= 0);
    /* if a pair touches at one end of the motion only, phi changes over a part of the motion only */
    const vec touched = vec_choose(both, vec_set(1), a - b),
              change = vec_choose(both | none, vec_set(1), depth - before);
    const vec slope = quotient(a, b, c) * touched * vec_reciprocal(change * (radius * (2 - depth - before)));
    const unsigned deep = vec_signs(SOLID_REPULSION_SHALLOW - vec_max(a, b));
    return deep ? slope_deep(slope, deep, p, depth, law->exponent) : slope;
}

static vec rounded(vec x, double quantum) { return solid_contact_list_rounded_vec(x, vec_set(quantum)); }

void solid_contact_touching_push(const struct solid_contact_touching *t, const struct solid_contact_law *law,
                                 const double (*now)[4], double (*push)[4]) {
    const struct series c = series_of(law->exponent);
    for (int from = 0; from < t->pairs; from += VEC_LANES) {
        const struct solid_contact_lanes p = some_of(t, from);
        vec between[4], end[3], on_h[4] = {0}, on_l[4] = {0}, end2 = vec_set(0);
        const int *h = t->h + from, *l = t->l + from;
        vec_shuffle_between4(now[0], 4, h, l, between);
        for (int i = 0; i < 3; i++) {
            end[i] = p.xi[i] + between[i];
            end2 += end[i] * end[i];
        }
        const vec slope = slope_of(&p, vec_max(end2, vec_set(law->least2)), law, &c);
        for (int i = 0; i < 3; i++) {
            const vec along = slope * (p.start[i] + end[i]);
            on_h[i] = rounded(p.on_h * along, law->quantum);
            on_l[i] = rounded(p.on_l * along, law->quantum);
        }
        double to_h[VEC_LANES][4], to_l[VEC_LANES][4];
        vec_shuffle_store4(to_h[0], on_h);
        vec_shuffle_store4(to_l[0], on_l);
        for (int k = 0; k < VEC_LANES; k++) {
            for (int i = 0; i < 4; i++) push[h[k]][i] += to_h[k][i];
            for (int i = 0; i < 4; i++) push[l[k]][i] -= to_l[k][i];
        }
    }
}
