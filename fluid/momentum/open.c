/* Explicit stage of the momentum equation for the normal velocity on an open side. */
#include "fluid/momentum/momentum.h"

/* What a row of one component needs: stride s of its own direction, strides a, b of the other two; the advecting
 * components qa, qb along these; metric factors. */
struct row {
    ptrdiff_t s, a, b;
    double convect_s, convect_a, convect_b; /* 1/(4 d), 1/m */
    double diffuse_s, diffuse_a, diffuse_b; /* nu/d^2, 1/s */
    double pressure, constant;              /* c/(rho d), c source */
    double factor, factor_old;              /* a, b of the stage */
};

static struct row row_of(const struct fluid_momentum_stage *st, int direction, int a, int b) {
    const struct fluid_grid *g = st->grid;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const double *d = g->d;
    return (struct row){.s = stride[direction],
                        .a = stride[a],
                        .b = stride[b],
                        .convect_s = 0.25 / d[direction],
                        .convect_a = 0.25 / d[a],
                        .convect_b = 0.25 / d[b],
                        .diffuse_s = st->viscosity / (d[direction] * d[direction]),
                        .diffuse_a = st->viscosity / (d[a] * d[a]),
                        .diffuse_b = st->viscosity / (d[b] * d[b]),
                        .pressure = st->c * st->inverse_density / d[direction],
                        .constant = st->c * st->source[direction],
                        .factor = st->a,
                        .factor_old = st->b};
}

void fluid_momentum_open_predict(const struct fluid_momentum_stage *st, int direction, int side,
                                 const double *const q[3], const double *p, double *const predicted[3],
                                 double *const rate[3]) {
    const struct fluid_grid *g = st->grid;
    const int a = direction == 0 ? 1 : 0, b = direction == 2 ? 1 : 2, face = side ? g->m[direction] - 1 : -1;
    const struct row r = row_of(st, direction, a, b);
    const ptrdiff_t in = side ? -r.s : r.s;
    const double *q_own = q[direction], *qa = q[a], *qb = q[b], sign = side ? 1 : -1;
    for (int l = 0; l < g->m[b]; l++)
        for (int j = 0; j < g->m[a]; j++) {
            int at[3];
            at[direction] = face;
            at[a] = j;
            at[b] = l;
            const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]);
            const double q0 = q_own[n], qi = q_own[n + in];
            const double own = sign * (4 * q0 * q0 - (q0 + qi) * (q0 + qi));
            const double over_a = (qa[n] + qa[n + r.s]) * (q0 + q_own[n + r.a]) -
                                  (qa[n - r.a] + qa[n - r.a + r.s]) * (q_own[n - r.a] + q0);
            const double over_b = (qb[n] + qb[n + r.s]) * (q0 + q_own[n + r.b]) -
                                  (qb[n - r.b] + qb[n - r.b + r.s]) * (q_own[n - r.b] + q0);
            const double now = r.diffuse_s * (qi - q0) + r.diffuse_a * (q_own[n + r.a] - 2 * q0 + q_own[n - r.a]) +
                               r.diffuse_b * (q_own[n + r.b] - 2 * q0 + q_own[n - r.b]) -
                               (r.convect_s * own + r.convect_a * over_a + r.convect_b * over_b);
            double next = q0 + r.factor * now + (r.constant - r.pressure * (p[n + r.s] - p[n]));
            if (r.factor_old != 0) next += r.factor_old * rate[direction][n];
            predicted[direction][n] = next;
            rate[direction][n] = now;
        }
}
