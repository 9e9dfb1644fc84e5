/* Periodic, Neumann-Neumann and Dirichlet-Dirichlet transforms of pairs of real lines, each pair as one complex line,
 * eight lines at once (fluid/poisson/fourier.h).
 *
 * Lines a and b give Z = FFT(v_a + i v_b), where v is the line itself (periodic), or (Makhoul 1980) its even places
 * forwards, then its odd places backwards; the odd places have the opposite sign for Dirichlet ends. With theta = pi
 * k/2n and
 *     S = Z_k + Z_{n-k} ,  D = -i (Z_k - Z_{n-k}) ,   k = 1 .. n/2 ,
 * the pair's coefficients k and n-k (a in the real, b in the imaginary part) are
 *     cos S + sin D ,  sin S - cos D         (Neumann: REDFT10; Dirichlet: RODFT10 from its end)
 *     S/2 ,  D/2                             (periodic: R2HC)
 * in FFTW's own order, sign and scale. */
#pragma once
#include "fluid/poisson/transform.h"

struct fluid_transform_pair; /* opaque: roots of unity, twiddles, scratch */

/* NULL if the two ends are of different kinds, or n has a large prime factor. Not collective. */
struct fluid_transform_pair *fluid_transform_pair_new(const struct fluid_transform_input *in);
void fluid_transform_pair_free(struct fluid_transform_pair *t);
void fluid_transform_pair_forward(const struct fluid_transform_pair *t, double *in_place);
void fluid_transform_pair_backward(const struct fluid_transform_pair *t, const double *from, double *to);
