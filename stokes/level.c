/* Products and sweeps with the matrix of a level. */
#include "stokes/level.h"

void stokes_level_fill(const struct stokes_level *l, float *x) {
    par_ghost_update_records(l->ghost, sizeof *x, x, l->n);
}

/* Sum of the weights times x over the neighbours of a cell. The neighbour before it along x is in last by a sweep
 * upwards, and the one after it downwards, so that little has to wait for the value just set. */
static inline float around_cell(const struct stokes_level *l, int i, int up, const float *x) {
    const int *q = l->next[i], last = up ? q[0] : q[1], other = up ? q[1] : q[0];
    const float *phi = l->phi[i], of_last = up ? l->phi[last][0] : phi[0], of_other = up ? phi[0] : l->phi[other][0];
    const float across = l->scale[1] * (l->phi[q[2]][1] * x[q[2]] + phi[1] * x[q[3]]) +
                         l->scale[2] * (l->phi[q[4]][2] * x[q[4]] + phi[2] * x[q[5]]);
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
        sum += l->scale[c] * (l->phi[q[2 * c]][c] * (x[i] - x[q[2 * c]]) + l->phi[i][c] * (x[i] - x[q[2 * c + 1]]));
    return sum;
}

static inline float across_row(const struct stokes_level *l, int i, const float *x) {
    float sum = l->extra[i] * x[i];
    for (int e = l->start[i]; e < l->start[i + 1]; e++) sum += l->weight[e] * (x[i] - x[l->column[e]]);
    return sum;
}

void stokes_level_product(const struct stokes_level *l, const float *x, float *y) {
    for (int i = 0; i < l->n; i++)
        y[i] = !(l->inverse[i] > 0) ? 0 : l->next ? across_cell(l, i, x) : across_row(l, i, x);
}
