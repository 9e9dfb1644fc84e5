/* Explicit stage of the momentum equation on an open side: the side's normal velocity, and the momentum of fluid
 * that enters. */
/* Fluid that leaves takes its momentum with it. Fluid that comes in brings the normal velocity of the cell that it
 * enters, as its gradient beyond the side is zero, and no velocity along the side. With differences towards the inside
 * in the first case, or with the cell's own velocity in the second, disturbances of an incoming flow grew like
 * exp(U t/d): nothing upstream of the side carries them away. Parallel flow does not see the difference. */
#include "fluid/grid/boundary.h"
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

/* Whether the low face of cell i of this rank is on a side of the domain. */
static int is_side(const struct fluid_grid *g, int d, int i) {
    return !g->periodic[d] && (g->lo[d] + i == 0 || g->lo[d] + i == g->n[d]);
}

/* The flux of the normal velocity along the side through an edge of its face, times 4: none where fluid comes in, but
 * through an edge on another side, whose condition holds. normal: the sum of the normal velocities on both sides of the
 * edge, m/s. */
static double along(const double *q, ptrdiff_t s, double sign, int on_side, double normal) {
    return fluid_boundary_comes_in(normal, sign) && !on_side ? 0 : (q[0] + q[s]) * normal;
}

void fluid_momentum_open_predict(const struct fluid_momentum_stage *st, int direction, int side, int drains,
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
            const double own = sign * (4 * fluid_boundary_open_flux(q0, qi, sign, drains) - (q0 + qi) * (q0 + qi));
            const double over_a = along(qa + n, r.s, sign, is_side(g, a, j + 1), q0 + q_own[n + r.a]) -
                                  along(qa + n - r.a, r.s, sign, is_side(g, a, j), q_own[n - r.a] + q0);
            const double over_b = along(qb + n, r.s, sign, is_side(g, b, l + 1), q0 + q_own[n + r.b]) -
                                  along(qb + n - r.b, r.s, sign, is_side(g, b, l), q_own[n - r.b] + q0);
            const double now = r.diffuse_s * (qi - q0) + r.diffuse_a * (q_own[n + r.a] - 2 * q0 + q_own[n - r.a]) +
                               r.diffuse_b * (q_own[n + r.b] - 2 * q0 + q_own[n - r.b]) -
                               (r.convect_s * own + r.convect_a * over_a + r.convect_b * over_b);
            double next = q0 + r.factor * now + (r.constant - r.pressure * (p[n + r.s] - p[n]));
            if (r.factor_old != 0) next += r.factor_old * rate[direction][n];
            predicted[direction][n] = next;
            rate[direction][n] = now;
        }
}

void fluid_momentum_open_incoming(const struct fluid_momentum_stage *st, int direction, int side, int c,
                                  const int first[3], const int last[3], const double *const q[3],
                                  double *const predicted[3], double *const rate[3]) {
    const struct fluid_grid *g = st->grid;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const double inward = (side ? -0.5 : 0.5) / g->d[direction];
    int low[3], high[3], at[3];
    for (int d = 0; d < 3; d++) low[d] = first[d], high[d] = last[d];
    low[direction] = side ? high[direction] - 1 : 0;
    high[direction] = low[direction] + 1;
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++) {
                const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]);
                const double *through = q[direction] + (side ? n : n - stride[direction]);
                const double in = inward * (through[0] + through[stride[c]]); /* 1/s */
                if (in <= 0) continue;
                const double carried = in * q[c][n];
                predicted[c][n] -= st->a * carried;
                rate[c][n] -= carried;
            }
}
