/* Loops over the pore cells of a rank: arrays and numbers in, arrays out. Arrays over cells have the entries of
 * stokes/cells.h: n own cells, the ghosts, and one 0 for all solid. Velocities have three components a cell, on the
 * faces at its high sides; those of closed faces are 0 (stokes/faces.h).
 *     next  [n][6]   places of the neighbours x low, x high, y low, ..
 *     kind  [..][3]  kinds of the faces; diagonal [3][256] of A, 1/m2, inverse 1/diagonal
 *     u, v, f, r     velocities, 3 floats or doubles a cell        p, q  [..] centres */
#pragma once
#include "stokes/faces.h"

/* v = A u (stokes/faces.h) in the cells first .. end - 1, v from its first place on.  u reads ghosts, 1/m2 */
void stokes_kernels_viscous(int first, int end, const int (*next)[6], const uint8_t (*kind)[3],
                            const float diagonal[3][256], const double d[3], const float (*u)[3], float (*v)[3]);
/* The rows of A of faces on sides of given pressure, in place of what stokes_kernels_viscous has left there.  inner:
 * direction of the neighbour along the axis c */
void stokes_kernels_viscous_halves(int halves, const struct stokes_faces_half *half, int c, const int (*next)[6],
                                   const float diagonal[3][256], const uint8_t (*kind)[3], const double d[3],
                                   const float (*u)[3], float (*v)[3]);
/* r = f - G p - A u on open faces, in double; f is `force` on component c, half as large on sides of given pressure.
 * u, p read ghosts */
void stokes_kernels_momentum(int n, const int (*next)[6], const uint8_t (*kind)[3], const double diagonal[3][256],
                             const double d[3], const double force[3], const double *p, const double (*u)[3],
                             float (*r)[3]);
void stokes_kernels_momentum_halves(int halves, const struct stokes_faces_half *half, int c, const int (*next)[6],
                                    const double diagonal[3][256], const uint8_t (*kind)[3], const double d[3],
                                    double force, const double *p, const double (*u)[3], float (*r)[3]);
/* r = G q, q reads ghosts, r in 1/m times q */
void stokes_kernels_gradient(int n, const int (*next)[6], const uint8_t (*kind)[3], const double d[3], const float *q,
                             float (*r)[3]);
/* q = G^T u, minus the divergence, each summed in double or in single precision.  u reads ghosts */
void stokes_kernels_divergence(int n, const int (*next)[6], const double d[3], const double (*u)[3], float *q);
void stokes_kernels_divergence_float(int n, const int (*next)[6], const double d[3], const float (*u)[3], float *q);

/* The loops of conjugate gradients, each component on its own.  e, r, s, v [n][3]; sums [3] are added to */
void stokes_kernels_dots(int n, const float (*s)[3], const float (*v)[3], double dot[3]);
/* e += alpha s, r -= alpha v */
void stokes_kernels_advance(int n, const double alpha[3], const float (*s)[3], const float (*v)[3], float (*e)[3],
                            float (*r)[3]);
/* s = z + beta s */
void stokes_kernels_direction(int n, const double beta[3], const float (*z)[3], float (*s)[3]);
