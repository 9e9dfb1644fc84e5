/* The family of a particle of a lattice: its offsets, their order and their weights. */
#include "base/par.h"
#include "solid/law/stencil.h"
#include "solid/law/weight.h"
#include "tests/check.h"

static const double ball = 4 * M_PI / 3;

/* At m = 3 all 178 sites with |step|^2 <= 12: each has its opposite, and the weights add up. */
static void stencil_of_three(void **state) {
    (void)state;
    const double spacing = 0.01;
    struct solid_stencil *t = solid_stencil_new(spacing, 3);
    double sum = 0;
    assert_int_equal(t->n, 178);
    assert_int_equal(t->reach, 3);
    for (int o = 0; o < t->n; o++) {
        const struct solid_offset *a = &t->offset[o], *b = &t->offset[t->n - 1 - o];
        for (int c = 0; c < 3; c++) assert_int_equal(a->step[c], -b->step[c]);
        check_equal(a->weight, b->weight);
        check_relative(a->inv_length2 * a->length * a->length, 1, 1e-15);
        if (a->length < 2 * spacing * (1 + 1e-9)) check_equal(a->weight, spacing * spacing * spacing);
        sum += a->weight;
    }
    check_relative(t->full_volume, sum, 1e-14);
    /* the ball less the middle cell, and less corners of cells that no bond goes to */
    const double all = (ball * 27 - 1) * spacing * spacing * spacing;
    check_between(t->full_volume / all, 0.99, 1);
    solid_stencil_free(t);
}

/* The count is that of the sites nearer than the horizon and half a spacing; the order is z, y, x; every weight is its
 * own partial volume, also where it was taken from a site of the same kind; lengths scale. */
static void sites_by_hand(void **state) {
    (void)state;
    const double ratio[4] = {1, 1.7, 2, 3.1}, spacing = 0.25;
    for (int k = 0; k < 4; k++) {
        struct solid_stencil *t = solid_stencil_new(spacing, ratio[k]), *unit = solid_stencil_new(1, ratio[k]);
        const double limit = ratio[k] + 0.5;
        int count = 0, last = -1;
        for (int z = -9; z <= 9; z++)
            for (int y = -9; y <= 9; y++)
                for (int x = -9; x <= 9; x++)
                    count += x * x + y * y + z * z > 0 && x * x + y * y + z * z < limit * limit * (1 - 1e-9);
        check_equal(t->n, count);
        check_equal(t->horizon, ratio[k] * spacing);
        for (int o = 0; o < t->n; o++) {
            const int *step = t->offset[o].step, place = (step[2] * 19 + step[1]) * 19 + step[0] + 9999;
            const double xi[3] = {step[0], step[1], step[2]};
            check_above(place, last);
            last = place;
            if (o % 7 == 0) check_relative(unit->offset[o].weight, solid_weight_fraction(xi, 1, ratio[k], 400), 1e-12);
            check_relative(t->offset[o].weight, unit->offset[o].weight * spacing * spacing * spacing, 1e-14);
            for (int c = 0; c < 3; c++) check_equal(t->offset[o].xi[c], spacing * step[c]);
        }
        solid_stencil_free(unit);
        solid_stencil_free(t);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(stencil_of_three), cmocka_unit_test(sites_by_hand)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
