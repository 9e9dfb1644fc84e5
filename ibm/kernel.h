/* Roma's kernel as three weights a direction; reading and writing of a marker's 3 x 3 x 3 block.  (001: sec. 3.5.1)
 * Rows are read four wide, for one vector register. The fourth value is ignored in reading, and 0 is added to it in
 * writing. It lies in the third ghost layer at most. */
#pragma once
#include "ibm/row.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* phi(t - i), i = -1, 0, 1, for a point at t in [-1/2, 1/2] cells from the grid point 0. The outer two follow from the
 * middle one, because sum phi = 1 and sum (t - i) phi = 0: one square root a direction.  (001: eq. 3.78) */
static inline void ibm_kernel_weights(double t, double w[3]) {
    const double middle = (1 + sqrt(1 - 3 * t * t)) / 3;
    w[0] = 0.5 * (1 - middle - t);
    w[1] = middle;
    w[2] = 0.5 * (1 - middle + t);
}

/* sum_j row_j y_j, three rows of four values */
static inline ibm_row ibm_kernel_rows(const double *field, ptrdiff_t row, double y0, double y1, double y2) {
    return ibm_row_set(y0) * ibm_row_load(field) + ibm_row_set(y1) * ibm_row_load(field + row) +
           ibm_row_set(y2) * ibm_row_load(field + 2 * row);
}

/* Planes whose weight is 0, as of an edge's piece, are left out in reading and in writing.
 *
 * sum_kji field w_z[k] w_y[j] w_x[i]  (001: eq. 3.79)
 * field: first value of the block; row, plane: strides of j and k; x [4], the last unused. */
static inline double ibm_kernel_gather(const double *field, ptrdiff_t row, ptrdiff_t plane, const double *x,
                                       const double *y, const double *z) {
    ibm_row sum = ibm_row_set(0);
    for (int k = 0; k < 3; k++)
        if (z[k] != 0) sum += ibm_row_set(z[k]) * ibm_kernel_rows(field + k * plane, row, y[0], y[1], y[2]);
    return sum[0] * x[0] + sum[1] * x[1] + sum[2] * x[2];
}

/* field += strength w_z[k] w_y[j] w_x[i]  (001: eq. 3.81)      x [4], the last 0. */
static inline void ibm_kernel_scatter(double *field, ptrdiff_t row, ptrdiff_t plane, const double *x, const double *y,
                                      const double *z, double strength) {
    const ibm_row along = ibm_row_load(x) * ibm_row_set(strength);
    for (int k = 0; k < 3; k++) {
        if (z[k] == 0) continue;
        const ibm_row slice = along * ibm_row_set(z[k]);
        for (int j = 0; j < 3; j++) {
            double *at = field + k * plane + j * row;
            ibm_row_store(at, ibm_row_load(at) + slice * ibm_row_set(y[j]));
        }
    }
}

/* Offset from the nearest face of a point that is t from the nearest centre. */
static inline double ibm_kernel_face(double t) { return t >= 0 ? t - 0.5 : t + 0.5; }

/* A marker away from all sides, one cache line. Its weights are computed from its offset where they are used. */
struct ibm_stencil {
    _Alignas(64) double t[3]; /* offset from the nearest centres, cells, in [-1/2, 1/2] */
    int64_t at;          /* index of the cell before the marker's own in each direction: its block's first centre */
    double v[3], volume; /* m/s; A_h dx / cell volume */
};
