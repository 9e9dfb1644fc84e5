/* The normal probe: pressure and stress at the root m, from the flow about the tip e = m + dl n.  (001: sec. 3.5.3)
 * On the 2 x 2 x 2 stencil of one cell about e, p and u are interpolated by the kernel and differenced. All of it is a
 * product of three one-dimensional sums: the mean of the kernels at the two points of a direction, or their difference.
 * So each field is a 4 x 4 x 4 block contracted with four values or four slopes a direction. */
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "ibm/kernel.h"
#include "ibm/state.h"

enum { SENT = 6, RETURNED = 5 }; /* tip in cells, normal; p|e, dp/dn|e, viscous traction */

/* Eight doubles: four values along x, twice. */
typedef double pair __attribute__((vector_size(64)));

/* The weights of a field's two sweeps, by alignment: value and slope of each of four rows or planes side by side in the
 * halves of a pair, and of the four values along x. */
struct tip {
    int first[3][2]; /* [direction][alignment] first grid point */
    pair y[2][4];    /* value | slope */
    double value_z[2][4], slope_z[2][4];
    pair value_x[2], mixed_x[2]; /* value | value, slope | value */
};

static pair pair_set(double low, double high) { return (pair){low, low, low, low, high, high, high, high}; }

static pair twice(const double *p) {
    const ibm_row line = ibm_row_load(p);
    return __builtin_shufflevector(line, line, 0, 1, 2, 3, 0, 1, 2, 3);
}

/* Both points of a direction are offset alike from their nearest grid points, i and i+1: four grid points i-1 .. i+2, with
 * the mean of the two kernels for the value, and their difference over the cell for the slope. The three directions in
 * two alignments are six lanes of one vector. */
static void tip_set(const struct fluid_grid *g, const double s[3], struct tip *e) {
    enum { LANES = 8 }; /* 3 alignment + direction; the last two idle */
    double low[LANES] = {0}, per_cell[LANES] = {0}, near[LANES], value[4][LANES], slope[4][LANES];
    for (int d = 0; d < 3; d++) {
        low[d] =
            s[d] - g->lo[d] - 1.0; /* the lower point, from the grid point 0, cells: centres stand at 1/2 */
        low[3 + d] = low[d] - 0.5; /* faces at 1 */
        per_cell[d] = per_cell[3 + d] = 1 / g->d[d];
    }
    for (int l = 0; l < LANES; l++) {
        double w[3];
        near[l] = floor(low[l] + 0.5);
        ibm_kernel_weights(low[l] - near[l], w);
        value[0][l] = 0.5 * w[0], slope[0][l] = -w[0] * per_cell[l];
        value[1][l] = 0.5 * (w[0] + w[1]), slope[1][l] = (w[0] - w[1]) * per_cell[l];
        value[2][l] = 0.5 * (w[1] + w[2]), slope[2][l] = (w[1] - w[2]) * per_cell[l];
        value[3][l] = 0.5 * w[2], slope[3][l] = w[2] * per_cell[l];
    }
    for (int a = 0; a < 2; a++) {
        const int x = 3 * a, y = x + 1, z = x + 2;
        for (int d = 0; d < 3; d++) e->first[d][a] = (int)near[x + d] - 1;
        for (int i = 0; i < 4; i++) {
            e->y[a][i] = pair_set(value[i][y], slope[i][y]);
            e->value_z[a][i] = value[i][z];
            e->slope_z[a][i] = slope[i][z];
        }
        const double v[4] = {value[0][x], value[1][x], value[2][x], value[3][x]};
        e->value_x[a] = (pair){v[0], v[1], v[2], v[3], v[0], v[1], v[2], v[3]};
        e->mixed_x[a] = (pair){slope[0][x], slope[1][x], slope[2][x], slope[3][x], v[0], v[1], v[2], v[3]};
    }
}

/* Value and gradient of one field at the tip: out[4] = f, df/dx, df/dy, df/dz.  (001: eqs 3.83, 3.84, 3.86)
 * at: first value of the block; x, y, z: the field's alignments. */
static inline void contract(const double *at, ptrdiff_t row, ptrdiff_t plane, const struct tip *e, int x,
                            int y, int z, double out[4]) {
    const pair y0 = e->y[y][0], y1 = e->y[y][1], y2 = e->y[y][2], y3 = e->y[y][3];
    pair mean_dy = pair_set(0, 0), dz = mean_dy;
    for (int k = 0; k < 4; k++, at += plane) {
        const pair sum =
            y0 * twice(at) + y1 * twice(at + row) + y2 * twice(at + 2 * row) + y3 * twice(at + 3 * row);
        mean_dy += e->value_z[z][k] * sum;
        dz += e->slope_z[z][k] * sum; /* its first half */
    }
    const pair a = e->value_x[x] * mean_dy; /* f | df/dy */
    const pair b =
        e->mixed_x[x] * __builtin_shufflevector(mean_dy, dz, 0, 1, 2, 3, 8, 9, 10, 11); /* df/dx | df/dz */
    const pair halves = __builtin_shufflevector(a, b, 0, 8, 4, 12, 2, 10, 6, 14) +
                        __builtin_shufflevector(a, b, 1, 9, 5, 13, 3, 11, 7, 15);
    for (int i = 0; i < 4; i++) out[i] = halves[i] + halves[4 + i];
}

/* One served probe: item[SENT] -> p|e, dp/dn|e, mu (grad u + grad u^T)|e n.  (001: eqs 3.88-3.95) */
static void measure(const struct fluid_grid *g, const struct fluid_state *f, double mu,
                    const double item[SENT], double result[RETURNED]) {
    const double *field[3] = {f->u, f->v, f->w}, *n = item + 3;
    struct tip e;
    double p[4], u[3][4];
    tip_set(g, item, &e);
    contract(f->p + fluid_grid_at(g, e.first[0][0], e.first[1][0], e.first[2][0]), g->row, g->plane, &e, 0, 0,
             0, p);
    for (int c = 0; c < 3; c++) {
        const size_t at = fluid_grid_at(g, e.first[0][c == 0], e.first[1][c == 1], e.first[2][c == 2]);
        contract(field[c] + at, g->row, g->plane, &e, c == 0, c == 1, c == 2, u[c]);
    }
    result[0] = p[0];
    result[1] = p[1] * n[0] + p[2] * n[1] + p[3] * n[2];
    for (int c = 0; c < 3; c++) {
        double t = 0;
        for (int d = 0; d < 3; d++) t += (u[c][d + 1] + u[d][c + 1]) * n[d];
        result[2 + c] = mu * t;
    }
}

/* The tips to their ranks, what they measure back. back [n][RETURNED] */
static const double *exchange(struct ibm *b, const struct ibm_probe_input *in, double length[3]) {
    const struct fluid_grid *g = b->grid;
    const struct fluid_input *fluid = fluid_input_of(b->fluid);
    struct ibm_route *route = &b->probe;
    double renew = ibm_route_reserve(route, in->n, SENT + RETURNED);
    double *sent = route->mine, *back = sent + (size_t)in->n * SENT;
    for (int h = 0; h < in->n; h++) {
        double *item = sent + (size_t)h * SENT;
        int cell[3];
        for (int d = 0; d < 3; d++) {
            item[d] = ibm_wrap(g, d, in->x[d][h] + length[d] * in->normal[d][h]);
            item[3 + d] = in->normal[d][h];
            cell[d] = ibm_cell(g, d, item[d]);
        }
        const int dest =
            cell[0] < 0 || cell[1] < 0 || cell[2] < 0 ? -1 : b->owner[1][cell[1]] + b->owner[2][cell[2]];
        if (dest != route->key[h]) renew = 1;
        route->key[h] = dest;
    }
    if (par_max(renew) > 0) {
        for (int h = 0; h < in->n; h++) route->dest[h] = (int)route->key[h];
        route->plan = par_exchange_renew(route->plan, in->n, NULL, route->dest);
    }
    const size_t served = (size_t)par_exchange_count(route->plan);
    ibm_reserve(&route->served, &route->served_size, served * (SENT + RETURNED) + 1);
    par_exchange_forward(route->plan, sent, route->served, SENT * sizeof(double));
    double *result = route->served + served * SENT;
    for (size_t h = 0; h < served; h++) /* in order of arrival: near particles have near numbers */
        measure(g, fluid_state_of(b->fluid), fluid->density * fluid->viscosity, route->served + h * SENT,
                result + h * RETURNED);
    par_exchange_backward(route->plan, result, back, RETURNED * sizeof(double));
    return back;
}

void ibm_probe(struct ibm *b, const struct ibm_probe_input *in, double *const traction[3], double *pressure,
               uint8_t *active) {
    clock_begin(CLOCK_PROBE);
    const struct fluid_input *fluid = fluid_input_of(b->fluid);
    double length[3], push[3], gradient[3] = {0, 0, 0};
    for (int d = 0; d < 3; d++) length[d] = in->length * b->grid->d[d];
    const double dl = length[0];
    /* forces per volume that the solved pressure balances in a fluid at rest */
    if (fluid->driving.type != FLUID_DRIVING_NONE)
        gradient[fluid->driving.direction] = fluid_state_of(b->fluid)->driving;
    for (int d = 0; d < 3; d++) push[d] = fluid->density * fluid->body_force[d] + gradient[d];
    const double *back = exchange(b, in, length);
    for (int h = 0; h < in->n; h++) {
        active[h] = b->probe.key[h] >= 0;
        pressure[h] = 0;
        for (int c = 0; c < 3; c++) traction[c][h] = 0;
        if (!active[h]) continue;
        const double *e = back + (size_t)h * RETURNED;
        /* dp/dn|m = rho (body force - dV_h/dt) . n */
        double at_root = in->acceleration_n ? -fluid->density * in->acceleration_n[h] : 0, drive = 0;
        for (int d = 0; d < 3; d++) {
            at_root += push[d] * in->normal[d][h];
            drive += gradient[d] * in->x[d][h];
        }
        /* p|m = p|e - dl/2 (dp/dn|m + dp/dn|e), signs for n outward  (001: eq. 3.85) */
        pressure[h] = e[0] - 0.5 * dl * (at_root + e[1]) - drive;
        for (int c = 0; c < 3; c++) traction[c][h] = e[2 + c] - pressure[h] * in->normal[c][h];
    }
    clock_end(CLOCK_PROBE);
}
