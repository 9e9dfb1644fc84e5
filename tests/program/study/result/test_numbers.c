/* Statistics, orders, extrapolation and times at equal error against hand-worked and published numbers. */
/* Statistics, orders, extrapolation and times at equal error, against numbers worked by hand or printed in the papers.
 */
#include "program/study/result/iso.h"
#include "program/study/result/order.h"
#include "program/study/result/richardson.h"
#include "program/study/result/statistic.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

/* 1, 2, 4, 7: mean 3.5, deviations squared 6.25 + 2.25 + 0.25 + 12.25 = 21. */
static void moments(void **state) {
    (void)state;
    const double x[] = {1, 2, 4, 7};
    check_close(study_statistic_mean(4, x), 3.5, 0);
    check_close(study_statistic_deviation(4, x), sqrt(7), 1e-15);
    assert_true(isnan(study_statistic_mean(0, x)));
    assert_true(isnan(study_statistic_deviation(1, x)));
}

static void quantiles(void **state) {
    (void)state;
    double x[6] = {7, 1, 4, 2, 9, 3};
    study_statistic_sort(5, x); /* 1 2 4 7 9 | 3 */
    check_close(study_statistic_quantile(5, x, 0.5), 4, 0);
    check_close(study_statistic_quantile(5, x, 0.25), 2, 0);
    check_close(study_statistic_quantile(5, x, 0.75), 7, 0);
    check_close(study_statistic_quantile(5, x, 0), 1, 0);
    check_close(study_statistic_quantile(5, x, 1), 9, 0);
    study_statistic_sort(6, x); /* 1 2 3 4 7 9 */
    check_close(study_statistic_quantile(6, x, 0.5), 3.5, 1e-15);
    check_close(study_statistic_quantile(6, x, 0.25), 2.25, 1e-15);
    check_close(study_statistic_quantile(6, x, 0.75), 6.25, 1e-15);
    check_close(study_statistic_quantile(1, x, 0.75), 1, 0);
    assert_true(isnan(study_statistic_quantile(0, x, 0.5)));
}

static void orders(void **state) {
    (void)state;
    check_close(study_order_between(0.04, 0.01, 0.2, 0.1), 2, 1e-14);
    check_close(study_order_between(0.027, 0.001, 3, 1), 3, 1e-14);
    assert_true(isnan(study_order_between(0.04, 0, 0.2, 0.1)));
    assert_true(isnan(study_order_between(0.04, 0.01, 0.2, 0.2)));
    assert_true(isnan(study_order_between(0.04, NAN, 0.2, 0.1)));
    const double h[4] = {1, 0.5, 0.25, 0.125}, square[4] = {3, 0.75, 0.1875, 0.046875};
    check_close(study_order_fit(4, h, square), 2, 1e-14);
    /* slopes 1 and 3 between three points in equal steps: the middle does not count, so (1 + 3)/2 */
    const double bent[3] = {16, 8, 1};
    check_close(study_order_fit(3, h, bent), 2, 1e-14);
    /* a point without a value is passed over */
    const double gap[4] = {3, NAN, 0.1875, 0};
    check_close(study_order_fit(4, h, gap), 2, 1e-14);
    assert_true(isnan(study_order_fit(1, h, square)));
    assert_true(isnan(study_order_fit(2, (double[]){2, 2}, square)));
}

/* f = 5 + 3 h^1.7, on steps with no common ratio: found to round-off. */
static void richardson_exact(void **state) {
    (void)state;
    const double h[3] = {0.1, 0.17, 0.31};
    double f[3];
    for (int i = 0; i < 3; i++) f[i] = 5 + 3 * pow(h[i], 1.7);
    const struct study_richardson r = study_richardson_three(f, h, 2);
    assert_int_equal(r.kind, STUDY_MONOTONE);
    check_close(r.order, 1.7, 1e-11);
    check_close(r.extrapolated, 5, 1e-11);
    check_close(r.gci, 1.25 * 3 * pow(0.1, 1.7), 1e-11);
    const struct study_richardson two = study_richardson_two(f, h, 1.7);
    check_close(two.extrapolated, 5, 1e-12);
    check_close(two.gci, 3 * 3 * pow(0.1, 1.7), 1e-12);
}

/* The three worked examples of Celik et al. 2008, table 1, to the digits printed there. Cells 18000, 8000, 4500 and
 * 18000, 4500, 980 in two dimensions. */
static void richardson_celik(void **state) {
    (void)state;
    static const struct {
        double cells[3], f[3], order, extrapolated, gci;
        enum study_convergence kind;
    } example[3] = {
        {{18000, 8000, 4500}, {6.063, 5.972, 5.863}, 1.53, 6.1685, 0.022, STUDY_MONOTONE},
        {{18000, 4500, 980}, {10.7880, 10.7250, 10.6050}, 0.75, 10.8801, 0.011, STUDY_MONOTONE},
        {{18000, 4500, 980}, {6.0042, 5.9624, 6.0909}, 1.51, 6.0269, 0.005, STUDY_OSCILLATORY},
    };
    for (int k = 0; k < 3; k++) {
        double h[3];
        for (int i = 0; i < 3; i++) h[i] = 1 / sqrt(example[k].cells[i]);
        const struct study_richardson r = study_richardson_three(example[k].f, h, 9);
        assert_int_equal(r.kind, example[k].kind);
        check_close(r.order, example[k].order, 0.006);
        check_close(r.extrapolated, example[k].extrapolated, 0.0006);
        check_close(r.gci / example[k].f[0], example[k].gci, 0.0006);
    }
}

/* Values that come together by chance: 1 %, then 0.01 % apart on grids halved each time. The observed order of 6.6
 * would give an index of 1.3e-6; with the formal order it is three times a third of the last difference. */
static void richardson_capped(void **state) {
    (void)state;
    const double f[3] = {1.0001, 1.0, 0.99}, h[3] = {0.25, 0.5, 1};
    const struct study_richardson r = study_richardson_three(f, h, 2);
    assert_int_equal(r.kind, STUDY_MONOTONE);
    assert_true(r.capped);
    check_close(r.order, log2(100), 1e-9);
    check_close(r.extrapolated, 1.0001 + 1e-4 / 3, 1e-12);
    check_close(r.gci, 1e-4, 1e-12);
    /* within a tenth of the formal order the factor stays 1.25 */
    const double near[3] = {0, pow(2, 2.1), pow(2, 2.1) + pow(2, 4.2)};
    check_close(study_richardson_three(near, h, 2).gci, 1.25 * pow(2, 2.1) / 3, 1e-9);
    assert_false(study_richardson_three(near, h, 3).capped);
}

static void richardson_none(void **state) {
    (void)state;
    const double h[3] = {1, 2, 4};
    assert_int_equal(study_richardson_three((double[]){1, 2, 2.5}, h, 2).kind, STUDY_DIVERGENT);
    assert_int_equal(study_richardson_three((double[]){1, 2, 2}, h, 2).kind, STUDY_DIVERGENT);
    assert_int_equal(study_richardson_three((double[]){1, 1, 2}, h, 2).kind, STUDY_FLAT);
    assert_int_equal(study_richardson_three((double[]){NAN, 1, 2}, h, 2).kind, STUDY_UNKNOWN);
    assert_int_equal(study_richardson_three((double[]){1, 2, 4}, (double[]){1, 1, 2}, 2).kind, STUDY_UNKNOWN);
    assert_true(isnan(study_richardson_three((double[]){1, 2, 2.5}, h, 2).order));
    assert_int_equal(study_richardson_two((double[]){1, 1}, h, 2).kind, STUDY_FLAT);
    assert_int_equal(study_richardson_two((double[]){1, 2}, h, 0).kind, STUDY_UNKNOWN);
}

static void iso(void **state) {
    (void)state;
    int at_most;
    const double time[4] = {1, 10, 100, 1000}, error[4] = {1e-1, 1e-2, 1e-3, 1e-4};
    check_close(study_iso_time(4, error, time, 1e-2, 0, &at_most), 10, 1e-12);
    check_close(study_iso_time(4, error, time, 0.03, 0, &at_most), 10 / 3.0, 1e-12); /* slope -1 */
    assert_false(at_most);
    check_close(study_iso_time(4, error, time, 0.2, 0, &at_most), 1, 0); /* its coarsest is better */
    assert_true(at_most);
    assert_true(isnan(study_iso_time(4, error, time, 0.5e-4, 0, &at_most)));
    assert_true(isnan(study_iso_time(4, error, time, 1e-3, 2e-3, &at_most)));
    /* an error that passes through zero by chance does not count */
    const double chance[4] = {1e-1, 1e-5, 1e-2, 1e-3};
    check_close(study_iso_time(4, chance, time, 3e-3, 0, &at_most), 100 * pow(10, log10(1e-2 / 3e-3)), 1e-9);
    /* a run that failed is passed over */
    const double gap[4] = {1e-1, NAN, 1e-3, 1e-4};
    check_close(study_iso_time(4, gap, time, 1e-2, 0, &at_most), 10, 1e-12);
    /* values that the reference does not resolve count as the floor: from 1e-2 at 10 to 1e-3 at 100 */
    const double deep[3] = {1e-1, 1e-2, 1e-9};
    check_close(study_iso_time(3, deep, time, 2e-3, 1e-3, &at_most), 50, 1e-10);
    check_close(study_iso_round(0), 1, 0);
    check_close(study_iso_round(1), 0.3, 0);
    check_close(study_iso_round(4), 0.01, 1e-17);
    check_close(study_iso_round(5), 0.003, 1e-17);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(moments),          cmocka_unit_test(quantiles),
                                       cmocka_unit_test(orders),           cmocka_unit_test(richardson_exact),
                                       cmocka_unit_test(richardson_celik), cmocka_unit_test(richardson_capped),
                                       cmocka_unit_test(richardson_none),  cmocka_unit_test(iso)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
