/* The staggered grid and this rank's piece of it.
 *
 * Pencils along x: a rank holds all of x and a piece of y and z. With local indices i,j,k = 0..m-1 (x fastest):
 *     p(i,j,k)  centre          x = (lo_x + i + 1/2) dx, y, z alike
 *     u(i,j,k)  right x face    x = (lo_x + i + 1)   dx, y and z at the centre
 *     v(i,j,k)  upper y face,   w(i,j,k)  far z face
 * so u(-1,j,k) is the low face of the domain, u(m_x-1,j,k) the high one. Every array has `halo` layers of ghosts on all
 * six sides, [m_z+2h][m_y+2h][m_x+2h]: h = 1 for a fluid alone, 3 when something is immersed. Rows are padded so that
 * the first cell of each starts a cache line, and so that a loop over eight cells at a time may run over a row's last
 * cell without touching the next row's ghosts. */
#pragma once
#include <stddef.h>

enum { FLUID_GRID_LANES = 8 }; /* cells of a cache line */

struct par_halo; /* base/par_halo.h */

struct fluid_grid {
    int n[3];         /* cells of the whole domain */
    double length[3]; /* m */
    double d[3];      /* cell size, m */
    int periodic[3];
    int halo;
    int lo[3], m[3];        /* this rank's first cell, and its number of cells */
    int ranks[3];           /* process grid: ranks[0] = 1 */
    int *cut[3];            /* [ranks + 1] first cells of the pieces; x is not cut */
    ptrdiff_t row, plane;   /* strides of j and k */
    ptrdiff_t first;        /* index of cell 0,0,0 in an array */
    size_t size;            /* doubles in an array with its ghosts */
    struct par_halo *halos; /* owned: exchange of ghosts between ranks and across periodic sides */
};

static inline size_t fluid_grid_at(const struct fluid_grid *g, int i, int j, int k) {
    return (size_t)(g->first + k * g->plane + j * g->row + i);
}

/* Chooses the process grid, and cuts y and z so that pieces have equal sums of weight[1] [n_y] and weight[2] [n_z];
 * NULL: equal numbers of cells. No piece has less than a third of these, or than `halo` cells. Dies (exit 2) if the
 * mesh cannot be divided over the ranks. Collective. */
struct fluid_grid *fluid_grid_new(const int n[3], const double length[3], const int periodic[3], int halo,
                                  const double *const weight[3]);
void fluid_grid_free(struct fluid_grid *g);
/* The process grid of `size` ranks; returns 0 if there is none. Not collective. */
int fluid_grid_choose(const int n[3], int size, int halo, int ranks[3]);
/* The cuts of fluid_grid_new along one direction: first [pieces + 1]. Not collective. */
void fluid_grid_cut(int n, const double *weight, int pieces, int halo, int *first);
size_t fluid_grid_cells(const struct fluid_grid *g); /* of the whole domain */
/* The rank that owns the cell holding the point, which is first wrapped in periodic directions; -1 outside the domain.
 * Not collective. */
int fluid_grid_rank_of(const struct fluid_grid *g, const double x[3]);
