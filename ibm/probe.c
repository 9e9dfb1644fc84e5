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

/* value and slope weights of the three directions, and each direction's first grid point, for both alignments */
struct tip {
    int first[3][2];
    double value[3][2][4], slope[3][2][4];
};

static void tip_set(const struct fluid_grid *g, const double s[3], struct tip *e) {
    const double point[2] = {0.5, 1.0}; /* position of the grid point 0, cells */
    for (int d = 0; d < 3; d++)
        for (int a = 0; a < 2; a++) {
            const double low = s[d] - g->lo[d] - point[a] - 0.5; /* the lower of the two points, from the grid point 0 */
            const double near = floor(low + 0.5);
            e->first[d][a] = (int)near - 1;
            ibm_kernel_pair(low - near, g->d[d], e->value[d][a], e->slope[d][a]);
        }
}

static double across(ibm_row r, const double x[4]) { return r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + r[3] * x[3]; }

/* Value and gradient of one field at the tip: out[4] = f, df/dx, df/dy, df/dz.  (001: eqs 3.83, 3.84, 3.86) */
static void contract(const double *field, const struct fluid_grid *g, const struct tip *e, const int align[3], double out[4]) {
    const double *at = field + fluid_grid_at(g, e->first[0][align[0]], e->first[1][align[1]], e->first[2][align[2]]);
    const double *value_y = e->value[1][align[1]], *slope_y = e->slope[1][align[1]];
    const double *value_z = e->value[2][align[2]], *slope_z = e->slope[2][align[2]];
    ibm_row mean = ibm_row_set(0), dy = mean, dz = mean;
    for (int k = 0; k < 4; k++) {
        ibm_row plane = ibm_row_set(0), plane_dy = plane;
        for (int j = 0; j < 4; j++) {
            const ibm_row line = ibm_row_load(at + k * g->plane + j * g->row);
            plane += ibm_row_set(value_y[j]) * line;
            plane_dy += ibm_row_set(slope_y[j]) * line;
        }
        mean += ibm_row_set(value_z[k]) * plane;
        dy += ibm_row_set(value_z[k]) * plane_dy;
        dz += ibm_row_set(slope_z[k]) * plane;
    }
    out[0] = across(mean, e->value[0][align[0]]);
    out[1] = across(mean, e->slope[0][align[0]]);
    out[2] = across(dy, e->value[0][align[0]]);
    out[3] = across(dz, e->value[0][align[0]]);
}

/* One served probe: item[SENT] -> p|e, dp/dn|e, mu (grad u + grad u^T)|e n.  (001: eqs 3.88-3.95) */
static void measure(const struct fluid_grid *g, const struct fluid_state *f, double mu, const double item[SENT],
                    double result[RETURNED]) {
    static const int align[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    const double *field[3] = {f->u, f->v, f->w}, *n = item + 3;
    struct tip e;
    double p[4], u[3][4];
    tip_set(g, item, &e);
    contract(f->p, g, &e, align[3], p);
    for (int c = 0; c < 3; c++) contract(field[c], g, &e, align[c], u[c]);
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
    const size_t n = (size_t)in->n;
    /* mine: tips [3][n], then the items as sent, then as returned */
    ibm_reserve(&route->mine, &route->mine_size, n * (3 + SENT + RETURNED));
    double *tip[3] = {route->mine, route->mine + n, route->mine + 2 * n};
    double *sent = route->mine + 3 * n, *back = sent + n * SENT;
    for (int h = 0; h < in->n; h++)
        for (int d = 0; d < 3; d++) {
            tip[d][h] = in->x[d][h] + length[d] * in->normal[d][h];
            sent[(size_t)h * SENT + (size_t)d] = ibm_wrap(g, d, tip[d][h]);
            sent[(size_t)h * SENT + 3 + (size_t)d] = in->normal[d][h];
        }
    ibm_route_set(route, g, in->n, (const double *const *)tip);
    const size_t served = (size_t)par_exchange_count(route->plan);
    ibm_reserve(&route->served, &route->served_size, served * (SENT + RETURNED));
    par_exchange_forward(route->plan, sent, route->served, SENT * sizeof(double));
    double *result = route->served + served * SENT;
    for (size_t k = 0; k < served; k++)
        measure(g, fluid_state_of(b->fluid), fluid->density * fluid->viscosity, route->served + k * SENT,
                result + k * RETURNED);
    par_exchange_backward(route->plan, result, back, RETURNED * sizeof(double));
    return back;
}

void ibm_probe(struct ibm *b, const struct ibm_probe_input *in, double *const traction[3], double *pressure, uint8_t *active) {
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
        active[h] = b->probe.dest[h] >= 0;
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
