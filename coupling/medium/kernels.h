/* Kernels of the medium: arrays and numbers in, arrays out. */
#pragma once
#include "fluid/grid/grid.h"

#include <stddef.h>
#include <stdint.h>

/* Adds the common volume, in cells, of a box [low, high] with each cell to f. low, high [3] are in cells from the
 * corner of cell (0,0,0), which f points to; the part outside first <= i < last is dropped. f  [last-first each
 * way]  centres  1  added to */
void medium_kernels_deposit(const double low[3], const double high[3], const int first[3], const int last[3],
                            ptrdiff_t row, ptrdiff_t plane, double *f);

/* Adds a cube's volume, in cells, to f, spread by Roma's kernel. s: its centre, in cells of the domain, in this rank's
 * cells; side: along each direction, in cells. f points to this rank's cell (0,0,0). What would be beyond a side that
 * is not periodic is folded back.  f  as fluid/grid/grid.h  centres  1  added to, up to MEDIUM_SPREAD_REACH ghost
 * layers */
enum { MEDIUM_SPREAD_REACH = 3 };
void medium_kernels_spread(const struct fluid_grid *g, const double s[3], const double side[3], double *f);

/* A cell is pore if less than half of it is solid. A cell that is half solid is solid, whatever the rounding of the
 * deposit. */
#define MEDIUM_KERNELS_HALF (0.5 - 1e-9)
static inline int medium_kernels_is_pore(double fraction) { return fraction < MEDIUM_KERNELS_HALF; }

/* Sums over cells with their weight W = wz wy wx, the part of the cell inside the box.
 * fraction, u, v, w  as fluid/grid/grid.h, pointing to (0,0,0); u, v, w read their low faces (-1) */
struct medium_sums {
    double solid;                 /* sum W f */
    double u[3];                  /* sum W u, W v, W w at centres */
    double pore_u[3], pore_speed; /* the same, and sum W |u|, over pore cells */
};
double medium_kernels_sum_solid(const int m[3], ptrdiff_t row, ptrdiff_t plane, const double *const weight[3],
                                const double *fraction);
struct medium_sums medium_kernels_sum_flow(const int m[3], ptrdiff_t row, ptrdiff_t plane,
                                           const double *const weight[3], const double *fraction, const double *u,
                                           const double *v, const double *w);

/* Connection of pore cells. A cell has one of these values: wall, pore, reached from the front, reached from both.
 * Level 1 floods from the front; level 2 from the back, within the cells of level 1. A rim of walls one cell thick on
 * all sides bounds the flood.
 *     cell   [mz+2][my+2][mx+2]
 *     stack  [mx my mz] indices into cell; the first n of these cells have just been set to level
 * Sets every cell of level - 1 that is connected to those. Returns how many. */
enum medium_cell { MEDIUM_WALL = 255, MEDIUM_PORE = 0, MEDIUM_FRONT = 1, MEDIUM_BOTH = 2 };
long medium_kernels_flood(const int m[3], uint8_t level, int n, int *stack, uint8_t *cell);
/* A row's m cells: sets those to pore or wall that are not what the fraction says (a pore is less than half solid, and
 * in the box). Returns 1 if one was not.  weight, fraction, cell  [m] */
int medium_kernels_compare(int m, double zy, const double *restrict weight, const double *restrict fraction,
                           uint8_t *restrict cell);
/* The pore volume of those of a row's m cells that both floods have reached, over zy, in cells. */
double medium_kernels_open(int m, const double *weight, const double *fraction, const uint8_t *cell);
