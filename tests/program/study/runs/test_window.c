/* One number of a sampled curve: last, largest, least, mean and time, within a window. */
#include "program/study/runs/window.h"
#include "tests/check.h"

/* t and x of each sample stand beside each other. */
static const double curve[][2] = {{0, 5}, {1, 1}, {2, NAN}, {3, -4}, {4, 2}, {8, 3}};

static double value(enum study_at at, double after, double before, double above) {
    const struct study_samples s = {.n = 6, .stride = 2, .t = &curve[0][0], .x = &curve[0][1]};
    return study_window(&s, at, after, before, above);
}

static void of_the_whole_curve(void **state) {
    (void)state;
    check_equal(value(STUDY_LAST, -INFINITY, INFINITY, 0), 3);
    check_equal(value(STUDY_FIRST, -INFINITY, INFINITY, 0), 5);
    check_equal(value(STUDY_FIRST, 2, INFINITY, 0), -4);
    check_equal(value(STUDY_MAX, -INFINITY, INFINITY, 0), 5);
    check_equal(value(STUDY_MIN, -INFINITY, INFINITY, 0), -4);
    check_equal(value(STUDY_TIME_MAX, -INFINITY, INFINITY, 0), 0);
    check_equal(value(STUDY_TIME_MAX, 0.5, INFINITY, 0), 8);
    /* trapezia, across the sample without a value: 3 + 2 (-1.5) - 1 + 4 2.5 over 8 */
    check_close(value(STUDY_MEAN, -INFINITY, INFINITY, 0), (3 - 3 - 1 + 10) / 8., 1e-15);
}

/* Both ends of the window belong to it. */
static void of_a_window(void **state) {
    (void)state;
    check_equal(value(STUDY_LAST, 1, 4, 0), 2);
    check_equal(value(STUDY_MAX, 1, 4, 0), 2);
    check_equal(value(STUDY_MIN, 0.5, 2.5, 0), 1);
    check_close(value(STUDY_MEAN, 1, 4, 0), (-3 - 1) / 3., 1e-15);
    check_equal(value(STUDY_MEAN, 4, 4, 0), 2); /* a single sample is its own mean */
}

static void first_time_above_a_limit(void **state) {
    (void)state;
    check_equal(value(STUDY_TIME, -INFINITY, INFINITY, 4.9), 0);
    check_equal(value(STUDY_TIME, 0.5, INFINITY, 1), 4); /* 1 is not above 1 */
    check_equal(value(STUDY_TIME, 1, 4, 0.5), 1);
    assert_true(isnan(value(STUDY_TIME, -INFINITY, INFINITY, 5)));
}

static void no_samples_no_number(void **state) {
    (void)state;
    for (enum study_at at = STUDY_LAST; at <= STUDY_TIME_MAX; at++) {
        assert_true(isnan(value(at, 9, INFINITY, -9)));
        assert_true(isnan(value(at, 1.5, 2.5, -9))); /* only a sample without a value */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_the_whole_curve), cmocka_unit_test(of_a_window),
                                       cmocka_unit_test(first_time_above_a_limit),
                                       cmocka_unit_test(no_samples_no_number)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
