/* Transforms of pairs of lines, by FFTW's transforms of single lines, and lines in all arrangements. */
#include "base/ensure.h"
#include "fluid/poisson/transform_pair.h"
#include "tests/fluid/fluid_case.h"

#include <fftw3.h>
#include <stdio.h>
#include <stdlib.h>

static const struct kind {
    enum fluid_end low, high;
    fftw_r2r_kind forward;
} kinds[] = {{FLUID_END_PERIODIC, FLUID_END_PERIODIC, FFTW_R2HC},
             {FLUID_END_NEUMANN, FLUID_END_NEUMANN, FFTW_REDFT10},
             {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET, FFTW_RODFT10}};
enum { MOST = 20, LONG = 256 };

static jmp_buf back;
static char condition[100];

/* Instead of the end of the program. */
_Noreturn void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...);
void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...) {
    (void)file, (void)line, (void)format;
    snprintf(condition, sizeof condition, "%s", cond);
    longjmp(back, 1);
}

static void single(fftw_r2r_kind kind, int n, double *q) {
    fftw_plan plan = fftw_plan_r2r_1d(n, q, q, kind, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
}

/* Lengths of all factors. */
static const int lengths[] = {2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,  13,  14,  15,  16,  18,
                              20, 24, 26, 32, 34, 48, 60, 64, 96, 98, 100, 122, 128, 160, 243, 256};

/* Nine lines give what each gives alone by FFTW, in the same order, sign and scale, and come back. */
static void pairs_are_singles(void **state) {
    (void)state;
    enum { LINES = 9 };
    static double a[LINES * LONG], b[LONG];
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
            const int n = lengths[i];
            const struct fluid_transform_input in = {
                .n = n, .low = kinds[k].low, .high = kinds[k].high, .lines = LINES, .stride = 1, .distance = n};
            struct fluid_transform_pair *pair = fluid_transform_pair_new(&in);
            if (!pair) fail_msg("no pair of lines of %d values, kind %d", n, k);
            for (int j = 0; j < LINES * n; j++) a[j] = random_at(k, n, 0, j);
            fluid_transform_pair_forward(pair, a);
            for (int l = 0; l < LINES; l++) {
                for (int j = 0; j < n; j++) b[j] = random_at(k, n, 0, l * n + j);
                single(kinds[k].forward, n, b);
                for (int j = 0; j < n; j++) check_close(a[l * n + j], b[j], 1e-14 * n);
            }
            fluid_transform_pair_backward(pair, a, a);
            for (int j = 0; j < LINES * n; j++)
                check_close(a[j], fluid_transform_scale(n, kinds[k].low, kinds[k].high) * random_at(k, n, 0, j),
                            1e-13 * n * n);
            fluid_transform_pair_free(pair);
        }
}

/* Lines side by side give what lines one after another give, backwards into an array of other distances. */
static void across_is_along(void **state) {
    (void)state;
    enum { LINES = 21, WIDE = LINES + 3 };
    for (int k = 0; k < 3; k++)
        for (int n = 2; n <= MOST; n += n < 5 ? 1 : 5) {
            const struct fluid_transform_input along = {
                .n = n, .low = kinds[k].low, .high = kinds[k].high, .lines = LINES, .stride = 1, .distance = MOST};
            struct fluid_transform_input across = along;
            across.stride = LINES;
            across.distance = 1;
            across.out_stride = WIDE;
            across.out_distance = 1;
            struct fluid_transform_pair *one = fluid_transform_pair_new(&along),
                                        *other = fluid_transform_pair_new(&across);
            double a[LINES * MOST], b[LINES * MOST], to[WIDE * MOST];
            for (int l = 0; l < LINES; l++)
                for (int i = 0; i < n; i++) a[l * MOST + i] = b[i * LINES + l] = random_at(k, n, l, i);
            fluid_transform_pair_forward(one, a);
            fluid_transform_pair_forward(other, b);
            for (int l = 0; l < LINES; l++)
                for (int i = 0; i < n; i++) check_close(b[i * LINES + l], a[l * MOST + i], 1e-14 * n);
            fluid_transform_pair_backward(one, a, a);
            fluid_transform_pair_backward(other, b, to);
            for (int l = 0; l < LINES; l++)
                for (int i = 0; i < n; i++) check_close(to[i * WIDE + l], a[l * MOST + i], 1e-13 * n);
            fluid_transform_pair_free(one);
            fluid_transform_pair_free(other);
        }
}

/* Ends of unlike kinds, and lengths with a large prime factor, are left to single transforms. */
static void not_in_pairs(void **state) {
    (void)state;
    struct fluid_transform_input in = {
        .n = 8, .low = FLUID_END_NEUMANN, .high = FLUID_END_NEUMANN, .lines = 2, .stride = 1, .distance = 134};
    in.n = 134;
    assert_null(fluid_transform_pair_new(&in));
    in.n = 8;
    in.high = FLUID_END_DIRICHLET;
    assert_null(fluid_transform_pair_new(&in));
    in.low = in.high = FLUID_END_FACE;
    assert_null(fluid_transform_pair_new(&in));
}

/* Lines one after another are written as such: another stride of the values is a bug of the caller. */
static void another_stride_along_lines_is_refused(void **state) {
    (void)state;
    struct fluid_transform_input in = {
        .n = 8, .low = FLUID_END_NEUMANN, .high = FLUID_END_NEUMANN, .lines = 2, .stride = 1, .distance = 8};
    in.out_stride = 2;
    in.out_distance = 16;
    if (setjmp(back) == 0) {
        fluid_transform_pair_new(&in);
        fail_msg("values two apart are not refused");
    }
    assert_non_null(strstr(condition, "out_stride == 1"));
}

FLUID_TEST_MAIN(cmocka_unit_test(pairs_are_singles), cmocka_unit_test(across_is_along), cmocka_unit_test(not_in_pairs),
                cmocka_unit_test(another_stride_along_lines_is_refused))
