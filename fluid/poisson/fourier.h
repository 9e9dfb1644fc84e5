/* Complex Fourier transforms of four lines at once, in the lanes of a vector:  Z_k = sum over j of z_j exp(-2 pi i j k
 * / n).  A value takes eight doubles: the real parts of the four lines, then their imaginary parts. No lane is moved,
 * and fused multiply-adds are used, so this takes half the time of FFTW's plans for many lines. */
#pragma once

enum { FLUID_FOURIER_LINES = 4, FLUID_FOURIER_VALUE = 2 * FLUID_FOURIER_LINES };

struct fluid_fourier; /* opaque: factors of n, roots of unity */

/* NULL if n has a prime factor for which another method is faster. Not collective. */
struct fluid_fourier *fluid_fourier_new(int n);
void fluid_fourier_free(struct fluid_fourier *f);
/* z [n][8] is transformed; other [n][8] is scratch. Returns the one of the two that holds the result. Not
 * collective. */
double *fluid_fourier_forward(const struct fluid_fourier *f, double *z, double *other);
