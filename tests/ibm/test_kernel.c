/* Roma's kernel: moments, known values, and the sweeps built from its weights. */
#include "base/par.h"
#include "ibm/ibm.h"
#include "ibm/kernel.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

/* sum phi(t - i) = 1, sum (t - i) phi(t - i) = 0, sum phi(t - i)^2 = 1/2 for every t */
static void moments(void **state) {
    (void)state;
    for (int n = 0; n <= 1000; n++) {
        const double t = -3 + n * 0.006;
        double sum = 0, first = 0, square = 0;
        for (int i = -6; i <= 6; i++) {
            const double phi = ibm_kernel(t - i);
            check_at_least(phi, 0);
            sum += phi, first += (t - i) * phi, square += phi * phi;
        }
        check_close(sum, 1, 1e-15);
        check_close(first, 0, 1e-15);
        check_close(square, 0.5, 1e-15);
    }
}

static void known_values(void **state) {
    (void)state;
    check_close(ibm_kernel(0), 2.0 / 3, 1e-16);
    check_close(ibm_kernel(0.5), 0.5, 1e-16);
    check_close(ibm_kernel(1), 1.0 / 6, 1e-16);
    check_close(ibm_kernel(-1), 1.0 / 6, 1e-16);
    check_equal(ibm_kernel(1.5), 0);
    check_equal(ibm_kernel(-1.6), 0);
}

static void weights_are_the_kernel(void **state) {
    (void)state;
    for (int n = 0; n <= 100; n++) {
        const double t = -0.5 + 0.01 * n;
        double w[3];
        ibm_kernel_weights(t, w);
        for (int i = 0; i < 3; i++) check_close(w[i], ibm_kernel(t - (i - 1)), 1e-15);
    }
}

/* Against plain sums over a block; the fourth column has no effect and is never changed. */
static void sweeps(void **state) {
    (void)state;
    enum { ROW = 5, PLANE = 4 * ROW, SIZE = 3 * PLANE };
    double field[SIZE], before[SIZE], x[4] = {0, 0, 0, 0}, y[3], z[3], expected = 0;
    ibm_kernel_weights(0.31, x);
    ibm_kernel_weights(-0.47, y);
    ibm_kernel_weights(0.05, z);
    for (int n = 0; n < SIZE; n++) field[n] = sin(1.7 * n);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) field[k * PLANE + j * ROW + 3] = NAN;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++) expected += field[k * PLANE + j * ROW + i] * x[i] * y[j] * z[k];
    check_close(ibm_kernel_gather(field, ROW, PLANE, x, y, z), expected, 1e-15);

    for (int n = 0; n < SIZE; n++) before[n] = field[n] = cos(0.3 * n);
    ibm_kernel_scatter(field, ROW, PLANE, x, y, z, -2.5);
    for (int n = 0; n < SIZE; n++) {
        const int i = n % ROW, j = n / ROW % 4, k = n / PLANE;
        const double added = i < 3 && j < 3 ? -2.5 * x[i] * y[j] * z[k] : 0;
        check_close(field[n] - before[n], added, 1e-15);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(moments), cmocka_unit_test(known_values),
                                       cmocka_unit_test(weights_are_the_kernel), cmocka_unit_test(sweeps)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
