/* The momentum equation's explicit stage, as one pass over the grid, and the two kernels of the projection. Pure.
 * (001: eqs 3.70, 3.72, 3.74) */
#pragma once
#include "fluid/grid/grid.h"

struct fluid_momentum_stage {
    const struct fluid_grid *grid;
    int faces[3];           /* number of faces of u, v, w along their own direction that this equation advances, from
                             * index 0 */
    double a, b, c;         /* dt alpha_r, dt beta_r, dt gamma_r, s */
    int store_rate;         /* 1: a later stage or step reads R; where it is 0, b is not 0 */
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
 *      rate[3]          faces     m/s2   read if b is not 0, written if store_rate
 *
 * Fluxes as in fluid/momentum/flux.h. Each face's flux is computed once and reused by the next cell: it is kept in a
 * register along x, for one row of each plane along y, and for a block of rows along z. So each cell reads its own
 * values and those of its neighbours to the right, above and behind. */
void fluid_momentum_predict(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                            double *const predicted[3], double *const rate[3]);

/* The same by groups of planes, with u* overwriting u, for a caller that uses u* while it is in the cache: first the
 * top plane, which is stored apart, top [3], each [m_y] rows from cell (0,0) on, strides 1 and g->row; then the planes
 * low
 * .. high-1 from 0 on, of which the last is copied from there. Once plane 0 is computed, the low ghosts of q are not
 * read. */
int fluid_momentum_group(const struct fluid_grid *g); /* number of planes that stay in the cache; 0: none, or there are
                                                       * several threads */
void fluid_momentum_predict_top(const struct fluid_momentum_stage *s, double *const q[3], const double *p,
                                double *const rate[3], double *const top[3]);
void fluid_momentum_predict_planes(const struct fluid_momentum_stage *s, int low, int high, double *const q[3],
                                   const double *p, double *const rate[3], double *const top[3]);

/* The same for faces on an open side (with a free normal velocity): the gradient of the normal velocity beyond the side
 * is zero. drains: as fluid_boundary_side. */
void fluid_momentum_open_predict(const struct fluid_momentum_stage *s, int direction, int side, int drains,
                                 const double *const q[3], const double *p, double *const predicted[3],
                                 double *const rate[3]);
/* Subtracts from u* and R of component c, which is tangential to an open side, the momentum that enters through it
 * because its ghosts continue the velocity evenly. For the faces first .. last-1 that are advanced; after
 * fluid_momentum_predict, whose q is not u*. */
void fluid_momentum_open_incoming(const struct fluid_momentum_stage *s, int direction, int side, int c,
                                  const int first[3], const int last[3], const double *const q[3],
                                  double *const predicted[3], double *const rate[3]);

/* Plane k: rhs = scale div q, [m_y][m_x] without padding, 1/s times scale. Reads the low ghosts. */
void fluid_momentum_kernels_divergence(const struct fluid_grid *g, int k, double scale, const double *const q[3],
                                       double *rhs);
/* The pressures that a stage's correction phi changes: p += share (pi + phi), from 0 in the first stage, then
 * pi += weight phi. Both arrays are of g->size. p may be pi itself, with weight 1: p += phi; or NULL: it is
 * not written. */
struct fluid_momentum_pressure {
    double *p, *pi; /* Pa */
    double weight;  /* (gamma_r/gamma_1)^2 */
    double share;   /* gamma_r: after the last stage p is the mean over the step */
    int is_first;   /* stage */
};

/* For the cells n .. n+count-1; phi [count]. */
void fluid_momentum_kernels_add(const struct fluid_momentum_pressure *to, size_t n, int count, const double *phi);
/* Plane k: q = predicted - c grad phi + shift on the owned faces, the pressures as above in the cells;
 * c = gamma_r dt / rho. q may be predicted.
 *     phi, above   centres of planes k, k+1, from cell (0,0) on, strides 1 and g->row; one ghost on the high sides */
void fluid_momentum_kernels_correct(const struct fluid_grid *g, int k, double c, const double shift[3],
                                    const double *phi, const double *above, double *const predicted[3],
                                    double *const q[3], const struct fluid_momentum_pressure *pressure);
