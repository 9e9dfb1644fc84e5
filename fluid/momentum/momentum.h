/* The momentum equation's explicit stage, as one pass over the grid, and the two kernels of the projection. Pure.
 * (001: eqs 3.70, 3.72, 3.74) */
#pragma once
#include "fluid/grid/grid.h"

struct fluid_momentum_stage {
    const struct fluid_grid *grid;
    int faces[3];           /* of u, v, w along their own direction: those that this equation advances, from index 0 */
    double a, b, c;         /* dt alpha_r, dt beta_r, dt gamma_r, s */
    int keep;               /* R is needed by a later stage: 0 in the last one, b then not 0 */
    double viscosity;       /* m2/s */
    double inverse_density; /* m3/kg */
    double source[3];       /* body force and driving per unit mass, m/s2 */
    double *work;           /* scratch, fluid_momentum_work doubles */
};

size_t fluid_momentum_work(const struct fluid_grid *g);

/* predicted = q + a R + b R_old + c (source - grad p / rho),  R = -div(q q) + nu lap q replaces R_old in rate.
 *
 *      q[3] = u, v, w   faces     m/s    one ghost layer read
 *      p                centres   Pa     one ghost layer read on the high sides
 *      predicted[3]     faces     m/s    written, also beyond the ends of rows; may be q itself
 *      rate[3]          faces     m/s2   read where b is not 0, written where it is to be kept
 *
 * Fluxes as fluid/momentum/flux.h; those through the faces before a cell are what its neighbour had after it: kept in a
 * register along x, for a row of each plane along y, for a block of rows along z. So a cell is read by itself and by
 * those before it only. */
void fluid_momentum_predict(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                            double *const predicted[3], double *const rate[3]);

/* The same for faces that lie on an open side (a free normal velocity): a zero gradient of the normal velocity beyond.
 */
void fluid_momentum_open_predict(const struct fluid_momentum_stage *s, int direction, int side,
                                 const double *const q[3], const double *p, double *const predicted[3],
                                 double *const rate[3]);

/* scale div q of plane k: rhs [m_y][m_x] tight, 1/s times scale. Reads the low ghosts. */
void fluid_momentum_kernels_divergence(const struct fluid_grid *g, int k, double scale, const double *const q[3],
                                       double *rhs);
/* Plane k: q = predicted - c grad phi + shift on the owned faces, p += phi in the cells. q is another array than
 * predicted, or the same.                                                                       c = gamma_r dt / rho
 *     phi, above   centres of planes k, k+1, from cell (0,0) on, strides 1 and g->row; with one ghost on the high sides
 */
void fluid_momentum_kernels_correct(const struct fluid_grid *g, int k, double c, const double shift[3],
                                    const double *phi, const double *above, double *const predicted[3],
                                    double *const q[3], double *p);
