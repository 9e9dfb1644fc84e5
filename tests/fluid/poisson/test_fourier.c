/* Cosine, sine and Fourier transforms of rows of real lines, by their definitions. */
#include "fluid/poisson/fourier.h"
#include "tests/check.h"
#include "tests/fluid/fluid_case.h"

#include <math.h>

enum { MOST = 130, ROW = FLUID_FOURIER_ROW, WIDE = ROW + 3, ENDS = 3 };
static const enum fluid_end ends[ENDS] = {FLUID_END_PERIODIC, FLUID_END_NEUMANN, FLUID_END_DIRICHLET};

/* What value j adds to coefficient k: FFTW's R2HC, REDFT10 and RODFT10. */
static double wave(enum fluid_end end, int n, int j, int k) {
    if (end == FLUID_END_NEUMANN) return 2 * cos(M_PI * ((2 * j + 1) * k % (4 * n)) / (2 * n));
    if (end == FLUID_END_DIRICHLET) return 2 * sin(M_PI * ((2 * j + 1) * (k + 1) % (4 * n)) / (2 * n));
    return k <= n / 2 ? cos(2 * M_PI * (j * k % n) / n) : -sin(2 * M_PI * (j * (n - k) % n) / n);
}

static void against_sums(enum fluid_end end, int n, struct fluid_fourier_rows found) {
    for (int k = 0; k < n; k += 1 + n / 8)
        for (int l = 0; l < ROW; l++) {
            double sum = 0;
            for (int j = 0; j < n; j++) sum += wave(end, n, j, k) * random_at(n, end, j, l);
            check_close(found.at[k * found.stride + l], sum, 1e-14 * n);
        }
}

/* Of all lengths: from rows far apart to rows of scratch, and back; from scratch to rows far apart, and back in place.
 * Between rows nothing is written. */
static void sums_of_waves(void **state) {
    (void)state;
    static double a[MOST * ROW], b[MOST * ROW], wide[MOST * WIDE];
    double *const scratch[2] = {a, b};
    const struct fluid_fourier_rows apart = {wide, WIDE}, taken = {a, ROW}, somewhere = {NULL, 0};
    for (int n = 2; n <= MOST; n++)
        for (int e = 0; e < ENDS; e++) {
            struct fluid_fourier *f = fluid_fourier_new(n, ends[e]);
            if (!f) continue;
            const double scale = fluid_transform_scale(n, ends[e], ends[e]);
            for (int i = 0; i < n * WIDE; i++) wide[i] = 1e3;
            for (int j = 0; j < n; j++)
                for (int l = 0; l < ROW; l++) wide[j * WIDE + l] = a[j * ROW + l] = random_at(n, ends[e], j, l);
            against_sums(ends[e], n, fluid_fourier_forward(f, taken, somewhere, scratch));
            against_sums(ends[e], n, fluid_fourier_forward(f, apart, apart, scratch));
            const struct fluid_fourier_rows back = fluid_fourier_backward(f, apart, somewhere, scratch);
            for (int j = 0; j < n; j++)
                for (int l = 0; l < ROW; l++)
                    check_close(back.at[j * back.stride + l], scale * random_at(n, ends[e], j, l), 1e-13 * scale);
            fluid_fourier_backward(f, apart, apart, scratch);
            for (int i = 0; i < n * WIDE; i++)
                if (i % WIDE < ROW)
                    check_close(wide[i], scale * random_at(n, ends[e], i / WIDE, i % WIDE), 1e-13 * scale);
                else
                    check_equal(wide[i], 1e3);
            fluid_fourier_free(f);
        }
}

/* One value is not a transform; a prime factor above 61 is left to FFTW. */
static void other_lengths(void **state) {
    (void)state;
    assert_null(fluid_fourier_new(1, FLUID_END_NEUMANN));
    assert_null(fluid_fourier_new(2 * 67, FLUID_END_NEUMANN));
    struct fluid_fourier *f = fluid_fourier_new(2 * 61, FLUID_END_NEUMANN);
    assert_non_null(f);
    fluid_fourier_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(sums_of_waves), cmocka_unit_test(other_lengths))
