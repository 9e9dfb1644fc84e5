/* The momentum equation's explicit stage, as one pass over the grid. Pure kernels.  (001: eqs 3.64-3.68; SPEC 1) */
#pragma once
#include "fluid/grid.h"

struct fluid_momentum_stage {
    const struct fluid_grid *grid;
    int faces[3]; /* of u, v, w along their own direction: those that this equation advances, from index 0 */
    double a, b, c;         /* dt alpha_r, dt beta_r, dt gamma_r, s */
    int keep;               /* R is needed by a later stage: 0 in the last one, b then not 0 */
    double viscosity;       /* m2/s */
    double inverse_density; /* m3/kg */
    double source[3];       /* body force and driving per unit mass, m/s2 */
};

/* predicted = q + a R + b R_old + c (source - grad p / rho),  R = -div(q q) + nu lap q replaces R_old in rate.
 *
 *      q[3] = u, v, w   faces     m/s    one ghost layer read
 *      p                centres   Pa     one ghost layer read on the high sides
 *      predicted[3]     faces     m/s    written
 *      rate[3]          faces     m/s2   read where b is not 0, written where it is to be kept
 *
 * The stencil of R at u(i), in one plane: own direction through the centres C, C', others through the corners at c, c'
 *
 *      ---v----c----v---
 *     |       |       |            d(uu)/dx = ((u + u_e)^2 - (u_w + u)^2) / 4 dx
 *   u_w   C   u  C'  u_e           d(vu)/dy = ((v + v_e)(u + u_n) - (v_s + v_se)(u_s + u)) / 4 dy
 *     |       |       |
 *      ---v----c'---v---                                                                                    */
void fluid_momentum_predict(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                            double *const predicted[3], double *const rate[3]);

/* The same for faces that lie on an open side (a free normal velocity): a zero gradient of the normal velocity beyond. */
void fluid_momentum_predict_open(const struct fluid_momentum_stage *s, int direction, int side,
                                 const double *const q[3], const double *p, double *const predicted[3],
                                 double *const rate[3]);

/* scale div q of plane k: rhs [m_y][m_x] tight, 1/s times scale. Reads the low ghosts. */
void fluid_momentum_divergence(const struct fluid_grid *g, int k, double scale, const double *const q[3],
                               double *rhs);
/* q = predicted - c grad phi + shift on all owned faces, p += phi in the cells; reads the high ghosts of phi.
 * c = gamma_r dt / rho */
void fluid_momentum_correct(const struct fluid_grid *g, double c, const double shift[3], const double *phi,
                            const double *const predicted[3], double *const q[3], double *p);
