/* Which cells of a lattice hold a particle: the cells that block light. */
#pragma once
#include <stddef.h>

struct postproc_voxels {
    int n[3];
    double origin[3], size; /* cell (i, j, k) covers origin + i size ... origin + (i+1) size, m */
    int *first;             /* [n2][n1][n0] a particle in the cell, or -1; owned */
};

/* x [n][3] m. The lattice is placed so that particles on a lattice of that spacing are in the cells' centres. Particles
 * outside low ... high have no cell. NULL if no particle is left. */
struct postproc_voxels *postproc_voxels_new(long n, const double (*x)[3], double size, const double low[3],
                                            const double high[3]);
void postproc_voxels_free(struct postproc_voxels *v);
int postproc_voxels_cell(const struct postproc_voxels *v, const double x[3], int cell[3]); /* returns 0 outside */

static inline int postproc_voxels_at(const struct postproc_voxels *v, int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= v->n[0] || j >= v->n[1] || k >= v->n[2]) return -1;
    return v->first[((size_t)k * (size_t)v->n[1] + (size_t)j) * (size_t)v->n[0] + (size_t)i];
}
