/* Factors that vary in time: values and means by hand. */
#include "base/par.h"
#include "solid/imposed/time.h"
#include "tests/check.h"

static const double moment[4] = {1, 2, 4, 4.5}, value[4] = {0, 3, -1, -1};
static const struct solid_time lines = {4, moment, value, 0};

static void constant_outside_straight_inside(void **state) {
    (void)state;
    const double t[] = {-5, 1, 1.5, 2, 2.5, 3.5, 4, 4.2, 4.5, 100}, factor[] = {0, 0, 1.5, 3, 2, 0, -1, -1, -1, -1};
    for (int k = 0; k < 10; k++) check_close(solid_time_factor(&lines, t[k]), factor[k], 1e-15);
}

static void without_points_one(void **state) {
    (void)state;
    const struct solid_time none = {0}, one = {1, moment, value + 1, 0};
    check_equal(solid_time_factor(&none, 7), 1);
    check_equal(solid_time_mean(&none, 7, 9), 1);
    check_equal(solid_time_factor(&one, -7), 3);
    check_equal(solid_time_mean(&one, -7, 9), 3);
}

/* Areas of triangles and trapezia. */
static void means_by_hand(void **state) {
    (void)state;
    check_close(solid_time_mean(&lines, 1, 2), 1.5, 1e-15);
    check_close(solid_time_mean(&lines, 2, 4), 1, 1e-15);
    check_close(solid_time_mean(&lines, 1, 4), (1.5 + 2) / 3, 1e-15);
    check_close(solid_time_mean(&lines, 0, 1.5), 0.5 * 0.5 * 1.5 / 1.5, 1e-15);
    check_close(solid_time_mean(&lines, 3, 6), (0.25 * 1 - 0.25 * 1 - 2) / 3, 1e-15);
    check_equal(solid_time_mean(&lines, 1.5, 1.5), 1.5);
    check_equal(solid_time_mean(&lines, -3, 0.5), 0);
    check_equal(solid_time_mean(&lines, 5, 6), -1);
}

/* The means over the pieces of a span, by their lengths, make the mean over all of it. */
static void pieces_make_the_whole(void **state) {
    (void)state;
    enum { PIECES = 37 };
    const double from = 0.3, to = 5.1;
    double sum = 0;
    for (int k = 0; k < PIECES; k++) {
        const double a = from + (to - from) * k / PIECES, b = from + (to - from) * (k + 1) / PIECES;
        sum += solid_time_mean(&lines, a, b) * (b - a);
    }
    check_close(sum / (to - from), solid_time_mean(&lines, from, to), 1e-14);
}

static void a_copy_is_its_own(void **state) {
    (void)state;
    double t[2] = {0, 1}, factor[2] = {5, 6};
    struct solid_time copy = {2, t, factor, 0};
    solid_time_copy(&copy);
    t[0] = factor[0] = t[1] = factor[1] = NAN;
    check_equal(solid_time_factor(&copy, 0.5), 5.5);
    solid_time_free(&copy);
    assert_int_equal(copy.n, 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(constant_outside_straight_inside),
                                       cmocka_unit_test(without_points_one), cmocka_unit_test(means_by_hand),
                                       cmocka_unit_test(pieces_make_the_whole), cmocka_unit_test(a_copy_is_its_own)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
