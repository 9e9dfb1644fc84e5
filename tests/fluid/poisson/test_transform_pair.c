/* Transforms of pairs of lines, by FFTW's transforms of single lines. */
#include "base/ensure.h"
#include "fluid/poisson/transform_pair.h"
#include "tests/fluid/fluid_case.h"

#include <stdio.h>
#include <stdlib.h>

static const struct kind {
    enum fluid_end low, high;
} kinds[] = {{FLUID_END_PERIODIC, FLUID_END_PERIODIC},
             {FLUID_END_NEUMANN, FLUID_END_NEUMANN},
             {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET}};
enum { MOST = 20 };

static jmp_buf back;
static char condition[100];

/* Instead of the end of the program. */
_Noreturn void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...);
void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...) {
    (void)file, (void)line, (void)format;
    snprintf(condition, sizeof condition, "%s", cond);
    longjmp(back, 1);
}

/* Two lines at once give what each gives alone, in the same order, sign and scale. */
static void pairs_are_singles(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++)
        for (int n = 2; n <= MOST; n += 2) {
            const struct fluid_transform_input one = {
                .n = n, .low = kinds[k].low, .high = kinds[k].high, .lines = 1, .stride = 1, .distance = n};
            struct fluid_transform_input two = one;
            two.lines = 2;
            struct fluid_transform *single = fluid_transform_new(&one);
            struct fluid_transform_pair *pair = fluid_transform_pair_new(&two);
            if (!pair) fail_msg("no pair of lines of %d values, kind %d", n, k);
            double a[2 * MOST], b[2 * MOST];
            for (int i = 0; i < 2 * n; i++) a[i] = b[i] = random_at(k, n, 0, i);
            fluid_transform_pair_forward(pair, a);
            for (int l = 0; l < 2; l++) fluid_transform_forward(single, b + l * n);
            for (int i = 0; i < 2 * n; i++) check_close(a[i], b[i], 1e-14 * n);
            fluid_transform_pair_backward(pair, a, a);
            for (int i = 0; i < 2 * n; i++)
                check_close(a[i], fluid_transform_scale(n, kinds[k].low, kinds[k].high) * random_at(k, n, 0, i),
                            1e-13 * n * n);
            fluid_transform_pair_free(pair);
            fluid_transform_free(single);
        }
}

/* Lines side by side give what lines one after another give, backwards into an array of other distances. */
static void across_is_along(void **state) {
    (void)state;
    enum { LINES = 6, WIDE = LINES + 3 };
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

/* An odd number of lines, and ends of unlike kinds, are left to single transforms. */
static void not_in_pairs(void **state) {
    (void)state;
    struct fluid_transform_input in = {
        .n = 8, .low = FLUID_END_NEUMANN, .high = FLUID_END_NEUMANN, .lines = 3, .stride = 1, .distance = 8};
    assert_null(fluid_transform_pair_new(&in));
    in.lines = 2;
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
