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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(numbers_ascend),
                                       cmocka_unit_test(a_permutation_becomes_its_indices),
                                       cmocka_unit_test(none_and_one)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
