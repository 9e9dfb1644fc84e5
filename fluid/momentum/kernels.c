/* Divergence of u* and correction by the pressure gradient, for one plane.  (001: eqs 3.71-3.73) */
#include "fluid/momentum/momentum.h"

void fluid_momentum_kernels_divergence(const struct fluid_grid *g, int k, double scale, const double *const q[3],
                                       double *rhs) {
    const double fx = scale / g->d[0], fy = scale / g->d[1], fz = scale / g->d[2];
    const ptrdiff_t row = g->row, plane = g->plane;
    for (int j = 0; j < g->m[1]; j++) {
        const size_t n = fluid_grid_at(g, 0, j, k);
        const double *restrict u = q[0] + n, *restrict v = q[1] + n, *restrict w = q[2] + n;
        double *restrict out = rhs + (ptrdiff_t)j * g->m[0];
        for (int i = 0; i < g->m[0]; i++)
            out[i] = fx * (u[i] - u[i - 1]) + fy * (v[i] - v[i - row]) + fz * (w[i] - w[i - plane]);
    }
}

static void correct_row(int count, double factor, double shift, const double *restrict phi, const double *restrict next,
                        const double *restrict from, double *restrict to) {
    for (int i = 0; i < count; i++) to[i] = from[i] - factor * (next[i] - phi[i]) + shift;
}

static void correct_row_in_place(int count, double factor, double shift, const double *restrict phi,
                                 const double *restrict next, double *restrict q) {
    for (int i = 0; i < count; i++) q[i] = q[i] - factor * (next[i] - phi[i]) + shift;
}

static void add_row(int count, double weight, const double *restrict phi, double *restrict pi) {
    for (int i = 0; i < count; i++) pi[i] += weight * phi[i];
}

/* p may hold anything before the first stage. */
static void begin_row_of_both(int count, double weight, double share, const double *restrict phi, double *restrict p,
                              double *restrict pi) {
    for (int i = 0; i < count; i++) {
        p[i] = share * (pi[i] + phi[i]);
        pi[i] += weight * phi[i];
    }
}

static void add_row_to_both(int count, double weight, double share, const double *restrict phi, double *restrict p,
                            double *restrict pi) {
    for (int i = 0; i < count; i++) {
        p[i] += share * (pi[i] + phi[i]);
        pi[i] += weight * phi[i];
    }
}

void fluid_momentum_kernels_add(const struct fluid_momentum_pressure *to, size_t n, int count, const double *phi) {
    if (!to->p || to->p == to->pi)
        add_row(count, to->weight, phi, to->pi + n);
    else if (to->is_first)
        begin_row_of_both(count, to->weight, to->share, phi, to->p + n, to->pi + n);
    else
        add_row_to_both(count, to->weight, to->share, phi, to->p + n, to->pi + n);
}

void fluid_momentum_kernels_correct(const struct fluid_grid *g, int k, double c, const double shift[3],
                                    const double *phi, const double *above, double *const predicted[3],
                                    double *const q[3], const struct fluid_momentum_pressure *pressure) {
    for (int j = 0; j < g->m[1]; j++) {
        const size_t n = fluid_grid_at(g, 0, j, k);
        const double *here = phi + j * g->row, *next[3] = {here + 1, here + g->row, above + j * g->row};
        for (int d = 0; d < 3; d++) {
            if (q[d] == predicted[d])
                correct_row_in_place(g->m[0], c / g->d[d], shift[d], here, next[d], q[d] + n);
            else
                correct_row(g->m[0], c / g->d[d], shift[d], here, next[d], predicted[d] + n, q[d] + n);
        }
        fluid_momentum_kernels_add(pressure, n, g->m[0], here);
    }
}
