/* Transforms in which the second difference is diagonal, by the difference itself. */
#include "fluid/poisson/transform.h"
#include "tests/fluid/fluid_case.h"

#include "tests/check.h"

#include <stdlib.h>

static const struct kind {
    enum fluid_end low, high;
} kinds[] = {{FLUID_END_PERIODIC, FLUID_END_PERIODIC},   {FLUID_END_NEUMANN, FLUID_END_NEUMANN},
             {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET}, {FLUID_END_NEUMANN, FLUID_END_DIRICHLET},
             {FLUID_END_DIRICHLET, FLUID_END_NEUMANN},   {FLUID_END_FACE, FLUID_END_FACE}};
enum { KINDS = sizeof kinds / sizeof kinds[0], MOST = 20 };

/* The value beyond an end: the other end's, the same, the opposite; beyond inner faces stands the side's own, 0. */
static double beyond(enum fluid_end end, double first, double other) {
    return end == FLUID_END_PERIODIC    ? other
           : end == FLUID_END_NEUMANN   ? first
           : end == FLUID_END_DIRICHLET ? -first
                                        : 0;
}

/* Backward from one coefficient: a vector that the second difference multiplies by that coefficient's eigenvalue. */
static void differences_are_diagonal(void **state) {
    (void)state;
    const double d = 0.3;
    for (int k = 0; k < KINDS; k++)
        for (int n = 3; n <= MOST; n += n < 9 ? 1 : 3) {
            const struct fluid_transform_input in = {
                .n = n, .low = kinds[k].low, .high = kinds[k].high, .lines = 1, .stride = 1, .distance = n};
            struct fluid_transform *t = fluid_transform_new(&in);
            const int values = kinds[k].low == FLUID_END_FACE ? n - 1 : n;
            double lambda[MOST], q[MOST];
            fluid_transform_eigenvalues(n, d, kinds[k].low, kinds[k].high, lambda);
            for (int m = 0; m < values; m++) {
                for (int i = 0; i < n; i++) q[i] = i == m;
                fluid_transform_backward(t, q, q);
                double size = 0;
                for (int i = 0; i < values; i++) size = check_worst(size, q[i]);
                check_above(size, 0.5);
                for (int i = 0; i < values; i++) {
                    const double before = i > 0 ? q[i - 1] : beyond(kinds[k].low, q[0], q[values - 1]);
                    const double behind = i < values - 1 ? q[i + 1] : beyond(kinds[k].high, q[values - 1], q[0]);
                    check_close((before - 2 * q[i] + behind) / (d * d), lambda[m] * q[i], 1e-12 * size / (d * d));
                }
            }
            fluid_transform_free(t);
        }
}

/* Forward and backward multiply by the scale: lines one after another or side by side, in place or to another array
 * with other distances; then what is transformed back is left as it is. Beyond the lines nothing is written. */
static void back_again(void **state) {
    (void)state;
    enum { N = 12, LINES = 4, CAPACITY = 100 };
    static const double untouched = 1e3;
    for (int k = 0; k < KINDS; k++)
        for (int form = 0; form < 8; form++) {
            const int lines = form & 1 ? LINES : LINES - 1, along = form & 2, other = form & 4;
            const int values = kinds[k].low == FLUID_END_FACE ? N - 1 : N;
            struct fluid_transform_input in = {.n = N, .low = kinds[k].low, .high = kinds[k].high, .lines = lines};
            in.stride = along ? 1 : LINES + 1;
            in.distance = along ? N + 2 : 1;
            in.out_stride = !other ? 0 : along ? 1 : LINES + 3;
            in.out_distance = !other ? 0 : along ? N + 5 : 1;
            struct fluid_transform *t = fluid_transform_new(&in);
            double q[CAPACITY], to[CAPACITY], before[CAPACITY], *is = other ? to : q;
            for (int i = 0; i < CAPACITY; i++) q[i] = to[i] = untouched;
            for (int l = 0; l < lines; l++)
                for (int i = 0; i < N; i++)
                    q[i * in.stride + l * in.distance] = i < values ? random_at(k, form, l, i) : 0;
            fluid_transform_forward(t, q);
            memcpy(before, q, sizeof q);
            fluid_transform_backward(t, q, is);
            if (other) assert_memory_equal(before, q, sizeof q);
            const double scale = fluid_transform_scale(N, kinds[k].low, kinds[k].high);
            const int stride = other ? in.out_stride : in.stride, distance = other ? in.out_distance : in.distance;
            for (int l = 0; l < lines; l++)
                for (int i = 0; i < N; i++) {
                    double *at = &is[i * stride + l * distance];
                    if (i < values) check_close(*at, scale * random_at(k, form, l, i), 1e-13 * scale);
                    if (i < values || !other) *at = untouched;
                }
            for (int i = 0; i < CAPACITY; i++) check_equal(is[i], untouched);
            fluid_transform_free(t);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(differences_are_diagonal), cmocka_unit_test(back_again)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
