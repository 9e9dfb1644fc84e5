/* Checks of numbers for the tests. A check that fails prints its file, line and text, the value, what was expected and
 * the tolerance, and fails cmocka's test. NaN fails every check. Each argument is evaluated once. Not collective. */
#pragma once
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
/* after the above */
#include <cmocka.h>

/* |ours - expected| <= tolerance */
#define check_close(ours, expected, tolerance)                                                                         \
    check_close_at(#ours, ours, #expected, expected, #tolerance, tolerance, __FILE__, __LINE__)
/* |ours - expected| <= tolerance |expected|; expected must not be 0 */
#define check_relative(ours, expected, tolerance)                                                                      \
    check_relative_at(#ours, ours, #expected, expected, #tolerance, tolerance, __FILE__, __LINE__)
/* low < ours < high */
#define check_between(ours, low, high) check_between_at(#ours, ours, #low, low, #high, high, __FILE__, __LINE__)
#define check_equal(ours, expected) check_order_at(#ours, ours, "==", #expected, expected, __FILE__, __LINE__)
#define check_below(ours, limit) check_order_at(#ours, ours, "<", #limit, limit, __FILE__, __LINE__)
#define check_above(ours, limit) check_order_at(#ours, ours, ">", #limit, limit, __FILE__, __LINE__)
#define check_at_most(ours, limit) check_order_at(#ours, ours, "<=", #limit, limit, __FILE__, __LINE__)
#define check_at_least(ours, limit) check_order_at(#ours, ours, ">=", #limit, limit, __FILE__, __LINE__)

/* Whether to leave out combination k: by day a test takes every nth, at night, with FRANA_THOROUGH, all of them. A
 * debug build, as under the sanitizers, is ten times as slow and looks at memory rather than at numbers: every 3 nth,
 * or, where all are taken by day, every second. */
static inline int check_skips(int k, int nth) {
#ifdef FRANA_DEBUG
    nth *= nth > 1 ? 3 : 2;
#endif
    return k % nth && !getenv("FRANA_THOROUGH");
}

/* The larger of a and |b|; infinite where b is NaN, which fmax would swallow. */
static inline double check_worst(double a, double b) { return isfinite(b) ? fmax(a, fabs(b)) : INFINITY; }

static inline void check_close_at(const char *text, double ours, const char *expected_text, double expected,
                                  const char *tolerance_text, double tolerance, const char *file, int line) {
    if (isfinite(tolerance) && (ours == expected || fabs(ours - expected) <= tolerance)) return;
    print_error("%s:%d: %s = %.17g\n  must be %s = %.17g\n  within %s = %.3g: it is off by %.3g\n", file, line, text,
                ours, expected_text, expected, tolerance_text, tolerance, ours - expected);
    _fail(file, line);
}

static inline void check_relative_at(const char *text, double ours, const char *expected_text, double expected,
                                     const char *tolerance_text, double tolerance, const char *file, int line) {
    if (isfinite(tolerance) && expected != 0 && fabs(ours - expected) <= tolerance * fabs(expected)) return;
    print_error("%s:%d: %s = %.17g\n  must be %s = %.17g\n  within %s = %.3g of it: it is off by %.3g of it\n", file,
                line, text, ours, expected_text, expected, tolerance_text, tolerance, (ours - expected) / expected);
    _fail(file, line);
}

static inline void check_between_at(const char *text, double ours, const char *low_text, double low,
                                    const char *high_text, double high, const char *file, int line) {
    if (ours > low && ours < high) return;
    print_error("%s:%d: %s = %.17g\n  must be above %s = %.17g\n  and below %s = %.17g\n", file, line, text, ours,
                low_text, low, high_text, high);
    _fail(file, line);
}

static inline void check_order_at(const char *text, double ours, const char *relation, const char *other_text,
                                  double other, const char *file, int line) {
    const int is_less = ours<other, is_equal = ours == other, is_more = ours> other;
    const int less = relation[0] == '<', more = relation[0] == '>', equal = strchr(relation, '=') != NULL;
    if ((less && is_less) || (more && is_more) || (equal && is_equal)) return;
    print_error("%s:%d: %s = %.17g\n  must be %s %s = %.17g\n", file, line, text, ours, relation, other_text, other);
    _fail(file, line);
}
