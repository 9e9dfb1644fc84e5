/* Sorted numbers ascend and are the numbers that were given. */
#include "base/sort.h"
#include "tests/check.h"

static void numbers_ascend(void **state) {
    (void)state;
    double x[] = {3, -0.5, 1e300, -INFINITY, 3, 0, INFINITY, -1e-300, 1e-300, 2};
    const double sorted[] = {-INFINITY, -0.5, -1e-300, 0, 1e-300, 2, 3, 3, 1e300, INFINITY};
    sort_ascending(x, 10);
    for (int i = 0; i < 10; i++) check_equal(x[i], sorted[i]);
}

/* A permutation of 0 .. n-1: k 37 mod 101 for k = 0 .. 100. */
static void a_permutation_becomes_its_indices(void **state) {
    (void)state;
    double x[101];
    for (int k = 0; k < 101; k++) x[k] = k * 37 % 101;
    sort_ascending(x, 101);
    for (int k = 0; k < 101; k++) check_equal(x[k], k);
}

static void none_and_one(void **state) {
    (void)state;
    double x = 4;
    sort_ascending(NULL, 0);
    sort_ascending(&x, 1);
    check_equal(x, 4);
}

static void each_once(void **state) {
    (void)state;
    long x[] = {9, 2, 2, 1L << 40, 9, 0, 2}, sorted[] = {0, 2, 9, 1L << 40}, one = 5;
    assert_int_equal(sort_unique(x, 7), 4);
    for (int k = 0; k < 4; k++) assert_int_equal(x[k], sorted[k]);
    assert_int_equal(sort_unique(&one, 1), 1);
    assert_int_equal(sort_unique(NULL, 0), 0);
}

static void the_last_that_is_not_above(void **state) {
    (void)state;
    const long x[] = {0, 3, 3, 8};
    assert_int_equal(sort_find(x, 4, -1), 0);
    assert_int_equal(sort_find(x, 4, 2), 0);
    assert_int_equal(sort_find(x, 4, 3), 2);
    assert_int_equal(sort_find(x, 4, 7), 2);
    assert_int_equal(sort_find(x, 4, 9), 3);
}

static void the_middle_one(void **state) {
    (void)state;
    check_equal(sort_median((double[]){5, 1, 3}, 3), 3);
    check_equal(sort_median((double[]){5, 1, 3, 2}, 4), 2.5);
    check_equal(sort_median(NULL, 0), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(numbers_ascend),
                                       cmocka_unit_test(a_permutation_becomes_its_indices),
                                       cmocka_unit_test(none_and_one),
                                       cmocka_unit_test(each_once),
                                       cmocka_unit_test(the_last_that_is_not_above),
                                       cmocka_unit_test(the_middle_one)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
