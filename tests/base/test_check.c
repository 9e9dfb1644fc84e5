/* The tests' own checks: what must pass passes, and what must fail fails, NaN always. What the second group prints
 * as failures is meant to. */
#include "tests/check.h"

#include <stdio.h>

static void passes(void **state) {
    (void)state;
    check_close(1.5, 1, 0.5);
    check_close(-INFINITY, -INFINITY, 0);
    check_relative(-2.2, -2, 0.11);
    check_between(0, -1, 1);
    check_equal(-0.0, 0);
    check_below(1, 2);
    check_above(INFINITY, 2);
    check_at_most(2, 2);
    check_at_least(2, 2);
    if (!isinf(check_worst(1, NAN)) || !isinf(check_worst(INFINITY, 1)) || check_worst(1, -3) != 3) fail();
    int evaluated = 0;
    check_between(++evaluated, 0, 2);
    assert_int_equal(evaluated, 1);
}

#define FAILS(name, check)                                                                                             \
    static void name(void **state) {                                                                                   \
        (void)state;                                                                                                   \
        check;                                                                                                         \
    }
FAILS(close_off, check_close(1.6, 1, 0.5))
FAILS(close_nan, check_close(NAN, 1, 1e9))
FAILS(close_of_nan, check_close(1, NAN, 1e9))
FAILS(close_to_nan, check_close(1, 1, NAN))
FAILS(close_to_infinity, check_close(1, 2, INFINITY))
FAILS(relative_off, check_relative(-2.3, -2, 0.11))
FAILS(relative_nan, check_relative(NAN, 1, 1))
FAILS(relative_to_zero, check_relative(0, 0, 1))
FAILS(between_low, check_between(-1, -1, 1))
FAILS(between_high, check_between(1, -1, 1))
FAILS(between_nan, check_between(NAN, -INFINITY, INFINITY))
FAILS(equal_off, check_equal(1, nextafter(1, 2)))
FAILS(equal_nan, check_equal(NAN, NAN))
FAILS(below_equal, check_below(2, 2))
FAILS(below_nan, check_below(NAN, 2))
FAILS(above_equal, check_above(2, 2))
FAILS(above_nan, check_above(2, NAN))
FAILS(at_most_more, check_at_most(3, 2))
FAILS(at_most_nan, check_at_most(NAN, 2))
FAILS(at_least_less, check_at_least(1, 2))
FAILS(at_least_nan, check_at_least(1, NAN))

int main(void) {
    const struct CMUnitTest good[] = {cmocka_unit_test(passes)};
    const struct CMUnitTest bad[] = {
        cmocka_unit_test(close_off),    cmocka_unit_test(close_nan),         cmocka_unit_test(close_of_nan),
        cmocka_unit_test(close_to_nan), cmocka_unit_test(close_to_infinity), cmocka_unit_test(relative_off),
        cmocka_unit_test(relative_nan), cmocka_unit_test(relative_to_zero),  cmocka_unit_test(between_low),
        cmocka_unit_test(between_high), cmocka_unit_test(between_nan),       cmocka_unit_test(equal_off),
        cmocka_unit_test(equal_nan),    cmocka_unit_test(below_equal),       cmocka_unit_test(below_nan),
        cmocka_unit_test(above_equal),  cmocka_unit_test(above_nan),         cmocka_unit_test(at_most_more),
        cmocka_unit_test(at_most_nan),  cmocka_unit_test(at_least_less),     cmocka_unit_test(at_least_nan)};
    if (cmocka_run_group_tests(good, NULL, NULL) != 0) return 1;
    const int all = sizeof bad / sizeof bad[0], failed = cmocka_run_group_tests(bad, NULL, NULL);
    printf("%d of %d checks that must fail have failed\n", failed, all);
    return failed != all;
}
