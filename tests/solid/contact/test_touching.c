/* The pairs that touch in a substep, a vec of them at a time, against the force of one pair
 * (solid/contact/repulsion.h). */
#include "base/memory.h"
#include "base/par.h"
#include "solid/contact/repulsion.h"
#include "solid/contact/touching.h"
#include "tests/check.h"

#include <stdlib.h>

enum { PAIRS = 203, ENDS = 60 };

static double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

/* A depth at one end of the motion: deep, shallow as in a pressed block, none. */
static double any_depth(void) {
    switch (rand() % 4) {
    case 0:
        return uniform(0.03, 0.5);
    case 1:
        return pow(10, uniform(-9, -2));
    case 2:
        return pow(10, uniform(-3.2, -2.8));
    default:
        return -pow(10, uniform(-9, -1));
    }
}

struct pair {
    double xi[3], start[3], depth, radius, on_h, on_l; /* as in struct solid_contact_lanes */
    int h, l;
};

/* Adds the pairs of some lanes; the other lanes are of nothing. */
static void add(struct solid_contact_touching *t, const struct pair *pair, int pairs) {
    struct solid_contact_lanes some;
    int h[VEC_LANES], l[VEC_LANES], n = 0;
    unsigned which = 0;
    memset(&some, 0xff, sizeof some); /* NaN */
    for (int lane = 0; lane < VEC_LANES && n < pairs; lane++) {
        if (rand() % 2 && VEC_LANES - lane > pairs - n) continue;
        for (int i = 0; i < 3; i++) {
            some.xi[i][lane] = pair[n].xi[i];
            some.start[i][lane] = pair[n].start[i];
        }
        some.depth[lane] = pair[n].depth;
        some.radius[lane] = pair[n].radius;
        some.on_h[lane] = pair[n].on_h;
        some.on_l[lane] = pair[n].on_l;
        h[n] = pair[n].h;
        l[n] = pair[n].l;
        n++;
        which |= 1u << lane;
    }
    solid_contact_touching_add(t, &some, which, h, l);
    solid_contact_touching_fill_up(t);
}

/* A pair along a random direction with given depths at both ends of the motion; `now` gives all ends 0. */
static struct pair pair_of(double before, double after, double radius) {
    struct pair p = {.depth = before,
                     .radius = radius,
                     .on_h = uniform(1, 2),
                     .on_l = uniform(1, 2),
                     .h = rand() % (ENDS / 2),
                     .l = ENDS / 2 + rand() % (ENDS / 2)};
    double direction[3], length = 0;
    for (int i = 0; i < 3; i++) length = hypot(length, direction[i] = uniform(0.2, 1));
    for (int i = 0; i < 3; i++) {
        p.start[i] = radius * (1 - before) * direction[i] / length;
        p.xi[i] = radius * (1 - after) * direction[i] / length;
    }
    return p;
}

/* Each acceleration to 1e-12 of itself, and to what the last digit of a distance means for it: 2e-16 of k_c V/rho, by
 * the exponent and the vector's components 5e-15. */
static void each_pair(void **state) {
    (void)state;
    const double radius = 0.7, exponent[2] = {1, 2.5};
    srand(5);
    for (int k = 0; k < 2 * PAIRS; k++) {
        const struct solid_contact_law law = {
            .exponent = exponent[k % 2], .quantum = 0x1p-90, .least2 = 1e-12 * radius * radius};
        static double now[ENDS][4], push[ENDS][4];
        memset(push, 0, sizeof push);
        const double before = any_depth(), after = any_depth();
        struct solid_contact_touching t = {0};
        struct pair p = pair_of(before, after, radius);
        double end2 = 0;
        for (int i = 0; i < 3; i++) end2 += p.xi[i] * p.xi[i];
        add(&t, &p, 1);
        solid_contact_touching_push(&t, &law, (const double(*)[4])now, push);
        const double potential = solid_repulsion_potential(before, radius, law.exponent);
        const double slope =
            solid_repulsion_slope(before, potential, solid_repulsion_depth(end2, radius), radius, law.exponent);
        for (int i = 0; i < 3; i++) {
            const double along = slope * (p.start[i] + p.xi[i]);
            check_close(push[p.h][i], p.on_h * along, 1e-12 * fabs(p.on_h * along) + 5e-15 * p.on_h);
            check_close(push[p.l][i], -p.on_l * along, 1e-12 * fabs(p.on_l * along) + 5e-15 * p.on_l);
        }
        solid_contact_touching_free(&t);
    }
}

/* Many pairs with common ends: the same to the bit in any order, and opposite where both ends feel as much. */
static void any_order(void **state) {
    (void)state;
    const double radius = 1.3;
    const struct solid_contact_law law = {.exponent = 1, .quantum = 0x1p-46, .least2 = 1e-12 * radius * radius};
    static struct pair pair[PAIRS];
    static double now[ENDS][4], push[2][ENDS][4];
    srand(6);
    memset(push, 0, sizeof push);
    for (int k = 0; k < PAIRS; k++) {
        pair[k] = pair_of(any_depth(), any_depth(), radius);
        pair[k].on_l = pair[k].on_h;
    }
    for (int order = 0; order < 2; order++) {
        struct solid_contact_touching t = {0};
        for (int k = 0, most = 1; k < PAIRS; k += most) {
            most = 1 + rand() % VEC_LANES;
            most = most < PAIRS - k ? most : PAIRS - k;
            add(&t, &pair[order ? PAIRS - k - most : k], most);
        }
        check_equal(t.pairs, PAIRS);
        solid_contact_touching_push(&t, &law, (const double(*)[4])now, push[order]);
        solid_contact_touching_free(&t);
    }
    assert_memory_equal(push[0], push[1], sizeof push[0]);
    double sum[3] = {0}, most = 0;
    for (int k = 0; k < ENDS; k++)
        for (int i = 0; i < 3; i++) {
            sum[i] += push[0][k][i];
            most = fmax(most, fabs(push[0][k][i]));
        }
    check_above(most, 0.1);
    for (int i = 0; i < 3; i++) check_equal(sum[i], 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_pair), cmocka_unit_test(any_order)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
