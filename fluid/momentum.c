#include "fluid/momentum.h"

/* What a row of one component needs: strides of its own direction s and of the other two a, b; the advecting components qa,
 * qb along those; metric factors. */
struct row {
    ptrdiff_t s, a, b;
    double convect_s, convect_a, convect_b; /* 1/(4 d), 1/m */
    double diffuse_s, diffuse_a, diffuse_b; /* nu/d^2, 1/s */
    double pressure, constant;              /* c/(rho d), c source */
    double factor, factor_old;              /* a, b of the stage */
};

static inline __attribute__((always_inline)) void
predict_row(const struct row r, int with_old, int keep, int count, const double *restrict q,
            const double *restrict qa, const double *restrict qb, const double *restrict p,
            double *restrict predicted, double *restrict rate) {
    const ptrdiff_t s = r.s, a = r.a, b = r.b;
    for (int n = 0; n < count; n++) {
        const double q0 = q[n], qe = q[n + s], qw = q[n - s], qn = q[n + a], qs = q[n - a], qt = q[n + b],
                     qf = q[n - b];
        const double own = (qe + q0) * (qe + q0) - (q0 + qw) * (q0 + qw);
        const double over_a = (qa[n] + qa[n + s]) * (q0 + qn) - (qa[n - a] + qa[n - a + s]) * (qs + q0);
        const double over_b = (qb[n] + qb[n + s]) * (q0 + qt) - (qb[n - b] + qb[n - b + s]) * (qf + q0);
        const double diffusion = r.diffuse_s * (qe - 2 * q0 + qw) + r.diffuse_a * (qn - 2 * q0 + qs) +
                                 r.diffuse_b * (qt - 2 * q0 + qf);
        const double now = diffusion - (r.convect_s * own + r.convect_a * over_a + r.convect_b * over_b);
        double next = q0 + r.factor * now + (r.constant - r.pressure * (p[n + s] - p[n]));
        if (with_old) next += r.factor_old * rate[n];
        predicted[n] = next;
        if (keep) rate[n] = now;
    }
}

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

/* The unit stride is written out, so that the compiler sees it. */
static inline __attribute__((always_inline)) void predict(const struct fluid_momentum_stage *st, int with_old,
                                                          int keep, const double *const q[3], const double *p,
                                                          double *const predicted[3], double *const rate[3]) {
    const struct fluid_grid *g = st->grid;
    struct row ru = row_of(st, 0, 1, 2), rv = row_of(st, 1, 0, 2), rw = row_of(st, 2, 0, 1);
    ru.s = rv.a = rw.a = 1;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t n = fluid_grid_at(g, 0, j, k);
            const double *u = q[0] + n, *v = q[1] + n, *w = q[2] + n;
            predict_row(ru, with_old, keep, st->faces[0], u, v, w, p + n, predicted[0] + n, rate[0] + n);
            if (j < st->faces[1])
                predict_row(rv, with_old, keep, g->m[0], v, u, w, p + n, predicted[1] + n, rate[1] + n);
            if (k < st->faces[2])
                predict_row(rw, with_old, keep, g->m[0], w, u, v, p + n, predicted[2] + n, rate[2] + n);
        }
}

void fluid_momentum_predict(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                            double *const predicted[3], double *const rate[3]) {
    if (s->b == 0)
        predict(s, 0, 1, q, p, predicted, rate);
    else if (s->keep)
        predict(s, 1, 1, q, p, predicted, rate);
    else
        predict(s, 1, 0, q, p, predicted, rate);
}

void fluid_momentum_predict_open(const struct fluid_momentum_stage *st, int direction, int side,
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
            const double now = r.diffuse_s * (qi - q0) +
                               r.diffuse_a * (q_own[n + r.a] - 2 * q0 + q_own[n - r.a]) +
                               r.diffuse_b * (q_own[n + r.b] - 2 * q0 + q_own[n - r.b]) -
                               (r.convect_s * own + r.convect_a * over_a + r.convect_b * over_b);
            double next = q0 + r.factor * now + (r.constant - r.pressure * (p[n + r.s] - p[n]));
            if (r.factor_old != 0) next += r.factor_old * rate[direction][n];
            predicted[direction][n] = next;
            rate[direction][n] = now;
        }
}

void fluid_momentum_divergence(const struct fluid_grid *g, int k, double scale, const double *const q[3],
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

void fluid_momentum_correct(const struct fluid_grid *g, double c, const double shift[3], const double *phi,
                            const double *const predicted[3], double *const q[3], double *p) {
    const double fx = c / g->d[0], fy = c / g->d[1], fz = c / g->d[2], sx = shift[0], sy = shift[1],
                 sz = shift[2];
    const ptrdiff_t row = g->row, plane = g->plane;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t n = fluid_grid_at(g, 0, j, k);
            const double *restrict f = phi + n, *restrict us = predicted[0] + n,
                                   *restrict vs = predicted[1] + n, *restrict ws = predicted[2] + n;
            double *restrict u = q[0] + n, *restrict v = q[1] + n, *restrict w = q[2] + n,
                             *restrict pressure = p + n;
            for (int i = 0; i < g->m[0]; i++) {
                u[i] = us[i] - fx * (f[i + 1] - f[i]) + sx;
                v[i] = vs[i] - fy * (f[i + row] - f[i]) + sy;
                w[i] = ws[i] - fz * (f[i + plane] - f[i]) + sz;
                pressure[i] += f[i];
            }
        }
}
