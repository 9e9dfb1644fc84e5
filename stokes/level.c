/* Products and sweeps with the matrix of a level. */
#include "stokes/level.h"

void stokes_level_fill(const struct stokes_level *l, float *x) {
    par_ghost_update_records(l->ghost, sizeof *x, x, l->n);
}

static inline float phi_of(const struct stokes_level *l, int i, int c) { return stokes_level_phi(l->phi[i][c]); }

/* Sum of the weights times x over the neighbours of a cell. The neighbour before it along x is in last by a sweep
 * upwards, and the one after it downwards, so that little has to wait for the value just set. */
static inline float around_cell(const struct stokes_level *l, int i, int up, const float *x) {
    const int *q = l->next[i], last = up ? q[0] : q[1], other = up ? q[1] : q[0];
    const float of_last = phi_of(l, up ? last : i, 0), of_other = phi_of(l, up ? i : other, 0);
    const float across = l->scale[1] * (phi_of(l, q[2], 1) * x[q[2]] + phi_of(l, i, 1) * x[q[3]]) +
                         l->scale[2] * (phi_of(l, q[4], 2) * x[q[4]] + phi_of(l, i, 2) * x[q[5]]);
    return across + l->scale[0] * of_other * x[other] + l->scale[0] * of_last * x[last];
}

static inline float around_row(const struct stokes_level *l, int i, const float *x) {
    float sum = 0;
    for (int e = l->start[i]; e < l->start[i + 1]; e++) sum += l->weight[e] * x[l->column[e]];
    return sum;
}

static void sweep_cells(const struct stokes_level *l, int up, const float *b, float *x) {
    for (int k = 0; k < l->n; k++) {
        const int i = up ? k : l->n - 1 - k;
        x[i] = l->inverse[i] * (b[i] + around_cell(l, i, up, x));
    }
}

void stokes_level_sweep(const struct stokes_level *l, int up, const float *b, float *x) {
    if (l->next && up) sweep_cells(l, 1, b, x);
    if (l->next && !up) sweep_cells(l, 0, b, x);
    for (int k = 0; k < l->n && !l->next; k++) {
        const int i = up ? k : l->n - 1 - k;
        x[i] = l->inverse[i] * (b[i] + around_row(l, i, x));
    }
}

/* Sums of w (x_i - x_j). */
static inline float across_cell(const struct stokes_level *l, int i, const float *x) {
    const int *q = l->next[i];
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum +=
            l->scale[c] * (phi_of(l, q[2 * c], c) * (x[i] - x[q[2 * c]]) + phi_of(l, i, c) * (x[i] - x[q[2 * c + 1]]));
    return sum;
}

static inline float across_row(const struct stokes_level *l, int i, const float *x) {
    float sum = l->extra[i] * x[i];
    for (int e = l->start[i]; e < l->start[i + 1]; e++) sum += l->weight[e] * (x[i] - x[l->column[e]]);
    return sum;
}

static inline float row_times(const struct stokes_level *l, int i, const float *x) {
    return !(l->inverse[i] > 0) ? 0 : l->next ? across_cell(l, i, x) : across_row(l, i, x);
}

void stokes_level_product(const struct stokes_level *l, const float *x, float *y) {
    for (int i = 0; i < l->n; i++) y[i] = row_times(l, i, x);
}

void stokes_level_energies(const struct stokes_level *l, const float *x, const float *y, double sum[2]) {
    sum[0] = sum[1] = 0;
    for (int i = 0; i < l->n; i++) {
        const double of_x = (double)row_times(l, i, x);
        sum[0] += (double)x[i] * of_x;
        sum[1] += (double)y[i] * of_x;
    }
}

void stokes_level_restrict(const struct stokes_level *l, const float *b, const float *x, int aggregates, float *to) {
    memset(to, 0, (size_t)aggregates * sizeof *to);
    for (int i = 0; i < l->n; i++)
        if (l->coarse[i] >= 0) to[l->coarse[i]] += b[i] - row_times(l, i, x);
}
