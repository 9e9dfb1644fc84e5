/* Fourier, cosine and sine transforms of pairs of real lines, each pair as one complex line, many pairs at once in the
 * lanes of vectors.
 *
 * Lines a and b give Z = FFT(v_a + i v_b), where v is the line itself (periodic), or (Makhoul 1980) its even places
 * forwards, then its odd places backwards; the odd places have the opposite sign for Dirichlet ends. With theta = pi
 * k/2n and
 *     S = Z_k + Z_{n-k} ,  D = -i (Z_k - Z_{n-k}) ,   k = 1 .. n/2 ,
 * the pair's coefficients k and n-k (a in the real, b in the imaginary part) are
 *     cos S + sin D ,  sin S - cos D         (Neumann: REDFT10; Dirichlet: RODFT10 from its end)
 *     S/2 ,  D/2                             (periodic: R2HC)
 * in FFTW's own order, sign and scale.
 *
 * A row is one value of all lines: lines l and l + PAIRS are a pair. No lane is moved. Rows are read by the first pass
 * and written by the last one, so that neither Makhoul's order nor the coefficients need a pass of their own. */
#pragma once
#include "base/vec_type.h"
#include "fluid/poisson/transform.h"
#include <stddef.h>

/* A row has at least a cache line's numbers. */
enum { FLUID_FOURIER_PAIRS = VEC_LANES > 4 ? VEC_LANES : 4, FLUID_FOURIER_ROW = 2 * FLUID_FOURIER_PAIRS };

struct fluid_fourier; /* opaque: factors of n, roots of unity, twiddles */

/* Where rows are: row j begins at at + j stride. */
struct fluid_fourier_rows {
    double *at;
    ptrdiff_t stride;
};

/* NULL if n has a prime factor for which another method is faster. Not collective. */
struct fluid_fourier *fluid_fourier_new(int n, enum fluid_end ends);
void fluid_fourier_free(struct fluid_fourier *f);
/* Rows of values to rows of coefficients, and back; scratch: two arrays of [n][ROW]. `from` may be the first of them,
 * or the same rows as `to`. If to.at is NULL the result is in one of the two. Returns where it is. Not collective. */
struct fluid_fourier_rows fluid_fourier_forward(const struct fluid_fourier *f, struct fluid_fourier_rows from,
                                                struct fluid_fourier_rows to, double *const scratch[2]);
struct fluid_fourier_rows fluid_fourier_backward(const struct fluid_fourier *f, struct fluid_fourier_rows from,
                                                 struct fluid_fourier_rows to, double *const scratch[2]);
