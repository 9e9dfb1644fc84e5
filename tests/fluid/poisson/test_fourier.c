/* Fourier transforms of four complex lines, by their definition. */
#include "fluid/poisson/fourier.h"
#include "tests/fluid/fluid_case.h"

#include <math.h>

enum { MOST = 130, VALUE = FLUID_FOURIER_VALUE, LINES = FLUID_FOURIER_LINES };

static void sums_of_waves(void **state) {
    (void)state;
    static double z[MOST * VALUE], other[MOST * VALUE], before[MOST * VALUE];
    for (int n = 2; n <= MOST; n++) {
        struct fluid_fourier *f = fluid_fourier_new(n);
        if (!f) continue;
        for (int i = 0; i < n * VALUE; i++) z[i] = before[i] = random_at(n, 0, 0, i);
        const double *found = fluid_fourier_forward(f, z, other);
        for (int k = 0; k < n; k += 1 + n / 8)
            for (int l = 0; l < LINES; l++) {
                double re = 0, im = 0;
                for (int j = 0; j < n; j++) {
                    const double c = cos(2 * M_PI * (j * k % n) / n), s = sin(2 * M_PI * (j * k % n) / n);
                    const double *at = before + j * VALUE + l;
                    re += c * at[0] + s * at[LINES];
                    im += c * at[LINES] - s * at[0];
                }
                check_close(found[k * VALUE + l], re, 1e-14 * n);
                check_close(found[k * VALUE + l + LINES], im, 1e-14 * n);
            }
        fluid_fourier_free(f);
    }
}

/* One value is no transform; a prime factor above 61 is left to FFTW. */
static void other_lengths(void **state) {
    (void)state;
    assert_null(fluid_fourier_new(1));
    assert_null(fluid_fourier_new(2 * 67));
    struct fluid_fourier *f = fluid_fourier_new(2 * 61);
    assert_non_null(f);
    fluid_fourier_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(sums_of_waves), cmocka_unit_test(other_lengths))
