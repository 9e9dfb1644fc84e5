/* Arithmetic in texts, and the mistakes in it. */
#include "program/study/expression.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

/* The number of characters in the brackets. */
static double length_of(const char *reference, const void *with) {
    (void)with;
    return (double)strlen(reference);
}

static double value(const char *text) {
    const char *why = NULL;
    const double x = study_expression_value(text, length_of, NULL, &why);
    if (why) fail_msg("%s: %s", text, why);
    return x;
}

static void precedence(void **state) {
    (void)state;
    check_equal(value("1 + 2 * 3 - 4 / 2"), 5);
    check_equal(value("2 ^ 3 ^ 2"), 512);
    check_equal(value("-2 ^ 2"), -4);
    check_equal(value("2 * -3"), -6);
    check_equal(value("2 ^ -1"), 0.5);
    check_equal(value("8 / 4 / 2"), 1);
    check_equal(value("(1 + 2) * 3"), 9);
    check_equal(value(" 1.5e-3 "), 1.5e-3);
}

static void functions(void **state) {
    (void)state;
    check_equal(value("sqrt(16) + abs(-2)"), 6);
    check_close(value("log(exp(2)) + cos(pi)"), 1, 1e-15);
    check_equal(value("min(3, 2) + max(3, 2)"), 5);
    check_equal(value("max(1, 4, 2, 3) - min(4, 1 + 1, 3)"), 2);
    check_close(value("atan(1) * 4 - pi"), 0, 1e-15);
    check_close(value("sin(pi / 6)"), 0.5, 1e-15);
}

static void references(void **state) {
    (void)state;
    check_equal(value("[abcd] / [a|b] - 1"), 4. / 3 - 1);
    check_equal(value("([a, (b)])"), 6);
}

static void mistakes(void **state) {
    (void)state;
    static const char *const bad[] = {"", "1 +", "(1", "1)", "[ab", "cube(2)", "min(1)", "sqrt 2", "1 2", "nan"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        const char *why = NULL;
        assert_true(isnan(study_expression_value(bad[k], length_of, NULL, &why)));
        assert_non_null(why);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(precedence), cmocka_unit_test(functions),
                                       cmocka_unit_test(references), cmocka_unit_test(mistakes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
