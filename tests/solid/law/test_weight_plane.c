/* Partial areas of square cells in a disc: hand-computed values, sums over lattices, and a direct integral. */
#include "base/par.h"
#include "solid/law/weight_plane.h"
#include "tests/check.h"

#include <stdlib.h>

static double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

/* The squares of a lattice together cover the disc; hand-computed values if the circle cuts a side or a corner. */
static void test_areas(void **state) {
    (void)state;
    srand(3);
    for (int trial = 0; trial < 200; trial++) {
        const double radius = uniform(0.3, 6), side = uniform(0.1, 2), shift[2] = {uniform(0, 1), uniform(0, 1)};
        const int reach = (int)(radius / side + 2);
        double area = 0;
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const double xi[2] = {side * (i + shift[0]), side * (j + shift[1])}, turned[2] = {-xi[1], xi[0]};
                const double part = solid_weight_plane_fraction(xi, side, radius);
                check_at_least(part, 0);
                check_at_most(part, 1);
                check_equal(part, solid_weight_plane_fraction(turned, side, radius));
                area += part * side * side;
            }
        /* the last digit of the angle in each of up to 500 cells on the circle */
        check_close(area / (M_PI * radius * radius), 1, 1e-12);
    }
    const double ahead[2] = {3, 0}, far[2] = {3.5, 0}, near[2] = {2, 0};
    check_equal(solid_weight_plane_fraction(far, 1, 3), 0);
    check_equal(solid_weight_plane_fraction(near, 1, 3), 1);
    /* the strip 2.5 < x, |y| < 1/2 under the arc: sqrt(9 - 1/4)/2 + 9 asin(1/6) - 2.5 */
    check_close(solid_weight_plane_fraction(ahead, 1, 3), sqrt(8.75) / 2 + 9 * asin(1. / 6) - 2.5, 1e-14);
}

/* A disc within the square; a square whose corner is the disc's centre; a circle so large that it is a line. */
static void closed_forms(void **state) {
    (void)state;
    check_relative(solid_weight_plane_fraction((double[]){0, 0}, 2, 0.9), M_PI * 0.81 / 4, 1e-14);
    check_relative(solid_weight_plane_fraction((double[]){-1, 1}, 2, 1.5), M_PI * 2.25 / 16, 1e-14);
    check_close(solid_weight_plane_fraction((double[]){0, -1e6}, 1, 1e6 + 0.2), 0.7, 1e-6);
}

/* Against the mean of chords over many columns; the edge of a disc costs some 1/columns^(3/2). */
static void direct_integral(void **state) {
    (void)state;
    enum { COLUMNS = 2000 };
    int cut = 0;
    srand(4);
    for (int trial = 0; trial < 300; trial++) {
        const double radius = uniform(0.3, 3), side = uniform(0.2, 2), xi[2] = {uniform(-3, 3), uniform(-3, 3)};
        const double low = xi[1] - side / 2, high = xi[1] + side / 2;
        double sum = 0;
        for (int i = 0; i < COLUMNS; i++) {
            const double x = xi[0] + side * ((i + 0.5) / COLUMNS - 0.5);
            const double half = sqrt(fmax(radius * radius - x * x, 0));
            sum += fmax(fmin(high, half) - fmax(low, -half), 0) / side / COLUMNS;
        }
        check_close(solid_weight_plane_fraction(xi, side, radius), sum, 1e-4);
        cut += sum > 0 && sum < 1;
    }
    check_above(cut, 100);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_areas), cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(direct_integral)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
