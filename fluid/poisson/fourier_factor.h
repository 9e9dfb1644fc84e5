/* Complex Fourier transforms of p values in registers, a value being some pairs of real lines: what the passes of
 * fluid/poisson/fourier.c do with a factor p. */
#pragma once
#include "base/vec.h"
#include "fluid/poisson/fourier.h"

#include <math.h>

#ifdef FRANA_DEBUG /* sanitizers would make the compiler take a quarter of a minute for all in one function */
#    define INLINE static inline
#else
#    define INLINE static inline __attribute__((always_inline))
#endif

struct complex_lanes {
    vec re, im;
};

INLINE struct complex_lanes load_row(const double *row) {
    return (struct complex_lanes){vec_load(row), vec_load(row + FLUID_FOURIER_PAIRS)};
}
INLINE void store_row(double *row, struct complex_lanes a) {
    vec_store(row, a.re);
    vec_store(row + FLUID_FOURIER_PAIRS, a.im);
}

INLINE struct complex_lanes plus(struct complex_lanes a, struct complex_lanes b) {
    return (struct complex_lanes){a.re + b.re, a.im + b.im};
}
INLINE struct complex_lanes minus(struct complex_lanes a, struct complex_lanes b) {
    return (struct complex_lanes){a.re - b.re, a.im - b.im};
}
INLINE struct complex_lanes times(double c, struct complex_lanes a) {
    return (struct complex_lanes){c * a.re, c * a.im};
}
INLINE struct complex_lanes minus_i_times(struct complex_lanes a) { return (struct complex_lanes){a.im, -a.re}; }
INLINE struct complex_lanes conjugate(struct complex_lanes a) { return (struct complex_lanes){a.re, -a.im}; }
/* a exp(-i phi), of the angle's cosine and sine. */
INLINE struct complex_lanes turned(struct complex_lanes a, double c, double s) {
    return (struct complex_lanes){c * a.re + s * a.im, c * a.im - s * a.re};
}

enum { FOURIER_LARGEST = 61 }; /* odd factor */

/* Transforms of p values, in place. Loops over an array of values are unrolled, so that it stays in registers. */

INLINE void dft_two(struct complex_lanes a[2]) {
    const struct complex_lanes sum = plus(a[0], a[1]), difference = minus(a[0], a[1]);
    a[0] = sum;
    a[1] = difference;
}

INLINE void dft_four(struct complex_lanes a[4]) {
    const struct complex_lanes even = plus(a[0], a[2]), odd = plus(a[1], a[3]);
    const struct complex_lanes difference = minus(a[0], a[2]), across = minus_i_times(minus(a[1], a[3]));
    a[0] = plus(even, odd);
    a[1] = plus(difference, across);
    a[2] = minus(even, odd);
    a[3] = minus(difference, across);
}

INLINE void dft_eight(struct complex_lanes a[8]) {
    struct complex_lanes even[4] = {a[0], a[2], a[4], a[6]}, odd[4] = {a[1], a[3], a[5], a[7]};
    dft_four(even);
    dft_four(odd);
    odd[1] = turned(odd[1], M_SQRT1_2, M_SQRT1_2);
    odd[2] = minus_i_times(odd[2]);
    odd[3] = turned(odd[3], -M_SQRT1_2, M_SQRT1_2);
#pragma GCC unroll 16
    for (int k = 0; k < 4; k++) {
        a[k] = plus(even[k], odd[k]);
        a[k + 4] = minus(even[k], odd[k]);
    }
}

INLINE void dft_sixteen(struct complex_lanes a[16]) {
    static const double c[10] = {1, 0.92387953251128674, M_SQRT1_2, 0.38268343236508977, 0, 0, -M_SQRT1_2, 0,
                                 0, -0.92387953251128674};
    static const double s[10] = {0, 0.38268343236508977, M_SQRT1_2, 0.92387953251128674, 1, 0, M_SQRT1_2, 0,
                                 0, -0.38268343236508977};
    struct complex_lanes b[4][4];
#pragma GCC unroll 16
    for (int i = 0; i < 4; i++) {
#pragma GCC unroll 16
        for (int r = 0; r < 4; r++) b[i][r] = a[i + 4 * r];
        dft_four(b[i]);
    }
#pragma GCC unroll 16
    for (int k = 0; k < 4; k++) {
        struct complex_lanes d[4] = {b[0][k], b[1][k], b[2][k], b[3][k]};
#pragma GCC unroll 16
        for (int i = 1; i < 4; i++)
            if (k > 0) d[i] = i * k == 4 ? minus_i_times(d[i]) : turned(d[i], c[i * k], s[i * k]);
        dft_four(d);
#pragma GCC unroll 16
        for (int r = 0; r < 4; r++) a[k + 4 * r] = d[r];
    }
}

/* p is odd; c, s: cosines and sines of 2 pi j/p, `step` apart. */
INLINE void dft_odd(int p, int step, const double *c, const double *s, struct complex_lanes *a) {
    struct complex_lanes sum[FOURIER_LARGEST / 2], difference[FOURIER_LARGEST / 2];
    const struct complex_lanes first = a[0];
    for (int j = 1; j <= p / 2; j++) {
        sum[j - 1] = plus(a[j], a[p - j]);
        difference[j - 1] = minus(a[j], a[p - j]);
        a[0] = plus(a[0], sum[j - 1]);
    }
    for (int k = 1; k <= p / 2; k++) {
        struct complex_lanes even = first, odd = {0 * first.re, 0 * first.im};
        for (int j = 1; j <= p / 2; j++) {
            even = plus(even, times(c[j * k % p * step], sum[j - 1]));
            odd = plus(odd, times(s[j * k % p * step], difference[j - 1]));
        }
        a[k] = plus(even, minus_i_times(odd));
        a[p - k] = minus(even, minus_i_times(odd));
    }
}

/* p: 1, 2, 4, 8, 16 or odd; c, s: cosines and sines of 2 pi j/n, n a multiple of p. */
INLINE void dft_factor(int p, int n, const double *c, const double *s, struct complex_lanes *a) {
    if (p == 2)
        dft_two(a);
    else if (p == 4)
        dft_four(a);
    else if (p == 8)
        dft_eight(a);
    else if (p == 16)
        dft_sixteen(a);
    else if (p > 1)
        dft_odd(p, n / p, c, s, a);
}
