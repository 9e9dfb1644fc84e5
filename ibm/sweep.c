/* Interpolates velocity at the inner markers and spreads their force increments.  (001: eqs 3.79-3.82) */
#include "ibm/state.h"

/* Indices of a marker's y and z weights by alignment, for the three components: at x faces, y faces, z faces. */
static const int align_y[3] = {1, 3 + 1, 1}, align_z[3] = {2, 2, 3 + 2}, align_x[3] = {3, 0, 0};

static inline ibm_row along_x(const double w[3][8], int c) {
    const int l = align_x[c];
    return (ibm_row){w[0][l], w[1][l], w[2][l], 0};
}

/* Prefetches the rows of the marker's block that the previous marker of the column did not touch. */
static inline void ask_ahead(const struct ibm_stencil *s, double *const u[3], ptrdiff_t row, ptrdiff_t plane) {
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) __builtin_prefetch(u[c] + s->at[c] + 2 * row + k * plane);
}

/* Sums over the 27 values of each component. */
static inline ibm_row block_velocity(const struct ibm_stencil *s, double *const u[3], ptrdiff_t row, ptrdiff_t plane) {
    double w[3][8];
    ibm_row part[3];
    ibm_kernel_expand(s, w);
    for (int c = 0; c < 3; c++) {
        const int y = align_y[c], z = align_z[c];
        const double *at = u[c] + s->at[c];
        ibm_row sum = ibm_row_set(0);
        for (int k = 0; k < 3; k++)
            sum += ibm_row_set(w[k][z]) * ibm_kernel_rows(at + k * plane, row, w[0][y], w[1][y], w[2][y]);
        part[c] = sum * along_x(w, c);
    }
    /* the fourth lanes are finite, but not part of the block */
    return (ibm_row){part[0][0] + part[0][1] + part[0][2], part[1][0] + part[1][1] + part[1][2],
                     part[2][0] + part[2][1] + part[2][2], 0};
}

enum { AHEAD = 24 }; /* number of markers that prefetching is ahead */

void ibm_sweep_gather(struct ibm *ibm, double *const u[3], int first, int last, enum ibm_keep keep,
                      struct ibm_tally *t) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    ibm_row given = ibm_row_set(0), squares = given;
    for (int h = first; h < last; h++) {
        const struct ibm_stencil *s = &ibm->stencil[h];
        ask_ahead(s + (h + AHEAD < ibm->inner ? AHEAD : 0), u, row, plane);
        const ibm_row lack = (ibm_row){s->v[0], s->v[1], s->v[2], 0} - block_velocity(s, u, row, plane);
        const ibm_row increment = lack * ibm_row_set(s->volume);
        given += increment;
        squares += lack * lack;
        for (int c = 0; c < 3; c++) ibm->increment[h][c] = increment[c];
        ibm_keep(ibm->received[h], ibm->increment[h], keep);
    }
    for (int c = 0; c < 3; c++) {
        t->given[c] += given[c];
        t->squares += squares[c];
    }
}

void ibm_sweep_read(const struct ibm *ibm, double *const u[3], int first, int last, double (*velocity)[3]) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    for (int h = first; h < last; h++) {
        const struct ibm_stencil *s = &ibm->stencil[h];
        ask_ahead(s + (h + AHEAD < ibm->inner ? AHEAD : 0), u, row, plane);
        const ibm_row block = block_velocity(s, u, row, plane);
        for (int c = 0; c < 3; c++) velocity[h][c] = block[c];
    }
}

void ibm_sweep_scatter(const struct ibm *ibm, double *const u[3], int first, int last) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    for (int h = first; h < last; h++) {
        const struct ibm_stencil *s = &ibm->stencil[h];
        double w[3][8];
        ask_ahead(s + (h + AHEAD < ibm->inner ? AHEAD : 0), u, row, plane);
        ibm_kernel_expand(s, w);
        for (int c = 0; c < 3; c++) {
            const ibm_row along = along_x(w, c) * ibm_row_set(ibm->increment[h][c]);
            const int y = align_y[c], z = align_z[c];
            double *at = u[c] + s->at[c];
            for (int k = 0; k < 3; k++, at += plane) {
                const ibm_row slice = along * ibm_row_set(w[k][z]);
                for (int j = 0; j < 3; j++)
                    ibm_row_store(at + j * row, ibm_row_load(at + j * row) + slice * ibm_row_set(w[j][y]));
            }
        }
    }
}
