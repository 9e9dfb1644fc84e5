/* Partial volumes: closed forms, symmetry, and cells that make up the ball. */
#include "base/par.h"
#include "solid/law/weight.h"
#include "tests/check.h"

#include <string.h>

static const double ball = 4 * M_PI / 3;

static void whole_and_none(void **state) {
    (void)state;
    check_equal(solid_weight_fraction((double[]){0, 0, 0}, 1, 0.87, 10), 1); /* its corner is at 0.866 */
    check_below(solid_weight_fraction((double[]){0, 0, 0}, 1, 0.8, 50), 1);
    check_equal(solid_weight_fraction((double[]){2, 0, 0}, 1, 1.5, 10), 0);
    check_above(solid_weight_fraction((double[]){2, 0, 0}, 1, 1.51, 50), 0);
}

/* A ball within the cube; a cap of the height h: pi h^2 (r - h/3); a sphere so large that it is a plane. Columns are
 * sampled at the middles of their cells, so the edge of a disc costs some 1/cells^(3/2). */
static void closed_forms(void **state) {
    (void)state;
    const double within = 1e-4;
    check_close(solid_weight_fraction((double[]){0, 0, 0}, 1, 0.4, 400), ball * 0.4 * 0.4 * 0.4, within);
    for (int c = 0; c < 3; c++) {
        double xi[3] = {0}, far[3] = {0};
        xi[c] = c == 1 ? -0.8 : 0.8;
        far[c] = 1e6;
        check_close(solid_weight_fraction(xi, 1, 0.4, 400), M_PI * 0.01 * (0.4 - 0.1 / 3), within);
        check_close(solid_weight_fraction(far, 1, 1e6 + 0.2, 10), 0.7, 1e-6);
    }
}

/* The parts of all cells, wherever the lattice stands, add up to the ball. */
static void cells_make_the_ball(void **state) {
    (void)state;
    const double radius = 3;
    for (int n = 0; n < 3; n++) {
        const double shift[3] = {0.21 * n, -0.3 * n, 0.4 * n};
        double sum = 0;
        for (int k = -5; k <= 5; k++)
            for (int j = -5; j <= 5; j++)
                for (int i = -5; i <= 5; i++)
                    sum += solid_weight_fraction((double[]){i + shift[0], j + shift[1], k + shift[2]}, 1, radius, 40);
        check_relative(sum, ball * 27, 1e-5);
    }
}

/* To the bit under exchange and signs; and from the table, where others have taken places in between. */
static void symmetric_and_kept(void **state) {
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    struct solid_weight_table *table = solid_weight_table_new();
    for (int n = 0; n < 1500; n++) {
        const double a[3] = {2.3 + 1e-4 * n, 1.1, -0.7};
        const double whole = solid_weight_fraction(a, 1, 2.8, 8);
        check_between(whole, 0, 1);
        for (int p = 0; p < 6; p++) {
            const double b[3] = {a[order[p][0]], -a[order[p][1]], a[order[p][2]]};
            check_equal(solid_weight_fraction(b, 1, 2.8, 8), whole);
            check_equal(solid_weight_fraction_cached(table, b, 1, 2.8, 8), whole);
        }
    }
    check_equal(solid_weight_fraction_cached(table, (double[]){2.3, 1.1, -0.7}, 1, 2.9, 8),
                solid_weight_fraction((double[]){2.3, 1.1, -0.7}, 1, 2.9, 8));
    solid_weight_table_free(table);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_and_none), cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(cells_make_the_ball), cmocka_unit_test(symmetric_and_kept)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
