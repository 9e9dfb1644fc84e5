/* Probability densities of samples with known laws: bins, moments, tails, degenerate samples. */
#include "base/par.h"
#include "postproc/data/pdf.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

/* The n quantiles of the standard normal law at (i + 1/2)/n, by bisection of erfc: a sample without noise. */
static double normal_quantile(double q) {
    double low = -10, high = 10;
    for (int k = 0; k < 60; k++) {
        const double x = 0.5 * (low + high);
        if (0.5 * erfc(-x / M_SQRT2) < q)
            low = x;
        else
            high = x;
    }
    return 0.5 * (low + high);
}

static double integral(const struct postproc_pdf *p) {
    double sum = 0;
    for (int i = 0; i < p->bins; i++) sum += p->density[i] * p->width;
    return sum;
}

static double first_moment(const struct postproc_pdf *p) {
    double sum = 0;
    for (int i = 0; i < p->bins; i++) sum += p->density[i] * p->width * (p->low + (i + 0.5) * p->width);
    return sum;
}

static void normal_law(void **state) {
    (void)state;
    enum { N = 20000 };
    double *x = malloc(N * sizeof *x);
    for (int i = 0; i < N; i++) x[i] = 3 + 0.5 * normal_quantile((i + 0.5) / N);
    struct postproc_pdf p = postproc_pdf_new(N, x);
    check_close(integral(&p), 1, 1e-12);
    check_close(p.mean, 3, 1e-9);
    check_close(first_moment(&p), 3, 0.1 * p.width);
    check_close(p.deviation, 0.5, 1e-3); /* the quantiles cut the tails off: 2e-4 at this n */
    /* the rule: 2 IQR n^(-1/3), IQR = 1.34898 sigma */
    check_close(p.width, 2 * 1.34898 * 0.5 / cbrt(N), 0.02 * p.width);
    for (int i = 0; i < p.bins; i++) { /* the density itself; an erf over the bin, off by one sample at most */
        const double a = (p.low + i * p.width - 3) / 0.5, b = a + p.width / 0.5;
        const double exact = 0.5 * (erf(b / M_SQRT2) - erf(a / M_SQRT2)) / p.width;
        check_close(p.density[i], exact, 1.01 / (N * p.width));
    }
    check_close(postproc_pdf_above(N, x, 3), 0.5, 1e-9);
    free(x);
}

/* A single value flung 1e6 widths away does not swallow the bins, and is counted. */
static void far_tail(void **state) {
    (void)state;
    enum { N = 10000 };
    double *x = malloc(N * sizeof *x);
    for (int i = 0; i < N; i++) x[i] = (i + 0.5) / N;
    x[N - 1] = 1e6;
    x[0] = NAN;
    struct postproc_pdf p = postproc_pdf_new(N, x);
    assert_int_equal(p.n, N - 1);
    check_between(p.outside, 0, 0.003 * N);
    check_at_least(p.bins, 16);
    check_below(p.width, 0.1);
    check_close(integral(&p), 1, 1e-12);
    check_close(p.density[p.bins / 2], 1, 0.01);
    check_close(p.largest, 1e6, 0);
    free(x);
}

static void alike_and_none(void **state) {
    (void)state;
    const double x[3] = {2e-4, 2e-4, 2e-4};
    struct postproc_pdf p = postproc_pdf_new(3, x);
    check_close(integral(&p), 1, 1e-12);
    check_close(p.mean, 2e-4, 1e-18);
    p = postproc_pdf_new(0, x);
    assert_int_equal(p.bins, 0);
    assert_true(isnan(postproc_pdf_above(0, x, 0)));
}

/* Most values are equal: the quartiles coincide, and the bins still contain all samples. */
static void no_quartiles(void **state) {
    (void)state;
    double x[100] = {0};
    for (int i = 90; i < 100; i++) x[i] = i - 89;
    struct postproc_pdf p = postproc_pdf_new(100, x);
    assert_int_equal(p.bins, 16);
    assert_int_equal(p.outside, 0);
    check_close(integral(&p), 1, 1e-12);
    check_close(p.density[0] * p.width, 0.90, 1e-12);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normal_law),
        cmocka_unit_test(far_tail),
        cmocka_unit_test(alike_and_none),
        cmocka_unit_test(no_quartiles),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
