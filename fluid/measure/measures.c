/* Integral measures of the flow: divergence, energy, bulk velocity, momentum, force on the box. */
#include "base/par.h"
#include "base/par_halo.h"
#include "fluid/internal.h"
#include "fluid/momentum/momentum.h"
#include "physics/rk3.h"

#include <math.h>
#include <string.h>

static double cell_volume(const struct fluid_grid *g) { return g->d[0] * g->d[1] * g->d[2]; }

double fluid_measures_divergence_max(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    double most = 0;
    for (int k = 0; k < g->m[2]; k++) {
        double *plane = fluid_poisson_plane(f->poisson, k); /* scratch between steps */
        fluid_momentum_kernels_divergence(g, k, 1, q, plane);
        for (int n = 0; n < g->m[0] * g->m[1]; n++)
            most = fabs(plane[n]) <= most ? most : plane[n] == plane[n] ? fabs(plane[n]) : INFINITY; /* a NaN shows */
    }
    return par_max(most);
}

/* Half the sum over cells of (low face^power + high face^power) of a component. */
static double sum_of_faces(const struct fluid *f, int c, int squared) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t s = fluid_boundary_stride(g, c);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
            double part = 0;
            for (int i = 0; i < g->m[0]; i++) part += squared ? q[i] * q[i] + q[i - s] * q[i - s] : q[i] + q[i - s];
            sum += part;
        }
    return 0.5 * sum;
}

double fluid_measures_bulk_velocity(struct fluid *f, int direction) {
    return par_sum(sum_of_faces(f, direction, 0)) / (double)fluid_cells(f);
}

double fluid_measures_kinetic_energy(struct fluid *f) {
    const double sum = sum_of_faces(f, 0, 1) + sum_of_faces(f, 1, 1) + sum_of_faces(f, 2, 1);
    return 0.5 * f->in.density * cell_volume(f->grid) * par_sum(sum);
}

void fluid_measures_mean_pressure(struct fluid *f, int direction, double *mean) {
    const struct fluid_grid *g = f->grid;
    const int n = g->n[direction];
    memset(mean, 0, (size_t)n * sizeof *mean);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double *p = f->state.p + fluid_grid_at(g, 0, j, k);
            const int section = direction == 1 ? j + g->lo[1] : k + g->lo[2];
            for (int i = 0; i < g->m[0]; i++) mean[direction == 0 ? i : section] += p[i];
        }
    par_sum_array(mean, n);
    for (int i = 0; i < n; i++) mean[i] *= n / (double)fluid_cells(f);
}

void fluid_advanced(const struct fluid *f, int c, int low[3], int high[3]) {
    const struct fluid_grid *g = f->grid;
    for (int d = 0; d < 3; d++) {
        low[d] = 0;
        high[d] = g->m[d];
    }
    const struct fluid_boundary_side *side = f->boundary->side[c];
    if (side[0].here && side[0].normal == FLUID_NORMAL_FREE) low[c] = -1;
    if (side[1].here && side[1].normal != FLUID_NORMAL_FREE) high[c] = g->m[c] - 1;
}

void fluid_measures_momentum(struct fluid *f, double out[3]) {
    const struct fluid_grid *g = f->grid;
    for (int c = 0; c < 3; c++) {
        int low[3], high[3];
        fluid_advanced(f, c, low, high);
        out[c] = 0;
        for (int k = low[2]; k < high[2]; k++)
            for (int j = low[1]; j < high[1]; j++) {
                const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
                double part = 0;
                for (int i = low[0]; i < high[0]; i++) part += q[i];
                out[c] += part;
            }
        out[c] *= f->in.density * cell_volume(g);
    }
    par_sum_array(out, 3);
}

/* The faces of component c next to one side of direction d, as fluid_advanced gives them. */
static void beside(const struct fluid *f, int c, int d, int side, int low[3], int high[3]) {
    fluid_advanced(f, c, low, high);
    low[d] = side ? high[d] - 1 : low[d];
    high[d] = low[d] + 1;
}

/* What is looked at: convection (1) or none of it, and diffusion with this viscosity. */
struct flux_kind {
    double convection, viscosity; /* 1; m2/s */
};

/* Flux of momentum of component c through the control surface at one side of direction d, outward, viscous traction
 * taken off: (q_d q_c - nu dq_c/dx_d) times the outward sign, summed over the side, m2/s2.
 * n: the last advanced value of c at the side; s: towards the outside. */
static double flux_through_side(const struct fluid *f, const double *const all[3], struct flux_kind kind, int c, int d,
                                int side) {
    const struct fluid_grid *g = f->grid;
    const double *q = all[c], *through = all[d];
    const double sign = side ? 1 : -1;
    const ptrdiff_t sd = fluid_boundary_stride(g, d), s = side ? sd : -sd, sc = fluid_boundary_stride(g, c);
    const int free_face = f->boundary->side[d][side].normal == FLUID_NORMAL_FREE;
    int low[3], high[3], at[3];
    double sum = 0;
    beside(f, c, d, side, low, high);
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++) {
                const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]);
                if (c == d && free_face) { /* beyond an open face: no gradient */
                    sum += kind.convection * sign * q[n] * q[n];
                } else if (c == d) { /* at the centre between the last advanced face and the side's own */
                    const double mean = 0.5 * (q[n] + q[n + s]);
                    sum += kind.convection * sign * mean * mean - kind.viscosity * (q[n + s] - q[n]) / g->d[d];
                } else { /* at the corners on the side's face */
                    const ptrdiff_t face = side ? n : n - sd;
                    const double velocity = 0.5 * (through[face] + through[face + sc]), mean = 0.5 * (q[n] + q[n + s]);
                    sum += kind.convection * sign * velocity * mean - kind.viscosity * (q[n + s] - q[n]) / g->d[d];
                }
            }
    return sum;
}

/* Pressure over density on the control surface of component d at one side of its direction, times the outward sign,
 * m2/s2. */
static double pressure_on_side(const struct fluid *f, int d, int side) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t up = side ? fluid_boundary_stride(g, d) : 0;
    int low[3], high[3], at[3];
    double sum = 0;
    beside(f, d, d, side, low, high);
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++)
                sum += f->state.p[(ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]) + up];
    return (side ? 1 : -1) * sum / f->in.density;
}

/* This rank's share of the box's force along c: sources and fluxes; pressure. N */
static double flux_force(const struct fluid *f, const double *const q[3], struct flux_kind kind, int c) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (f->boundary->side[d][side].here) sum -= flux_through_side(f, q, kind, c, d, side) / g->d[d];
    return f->in.density * cell_volume(g) * sum;
}

static double source_force(const struct fluid *f, int c, double driving) {
    int low[3], high[3];
    fluid_advanced(f, c, low, high);
    const double faces = (double)(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    const double source = f->in.body_force[c] + (c == f->in.driving.direction ? driving / f->in.density : 0);
    return f->in.density * cell_volume(f->grid) * faces * source;
}

static double pressure_force(const struct fluid *f, int c) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int side = 0; side < 2; side++)
        if (f->boundary->side[c][side].here) sum -= pressure_on_side(f, c, side) / g->d[c];
    return f->in.density * cell_volume(g) * sum;
}

void fluid_measures_box_force(struct fluid *f, double out[3]) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct flux_kind whole = {1, f->in.viscosity};
    for (int c = 0; c < 3; c++)
        out[c] = flux_force(f, q, whole, c) + source_force(f, c, f->state.driving) + pressure_force(f, c);
    par_sum_array(out, 3);
}

void fluid_audit_begin(struct fluid *f) { f->audit = (struct fluid_audit){.on = 1}; }

void fluid_audit_flux(struct fluid *f, int r) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct flux_kind kind = {1, f->diffusion ? 0 : f->in.viscosity};
    for (int c = 0; c < 3; c++) {
        const double flux = flux_force(f, q, kind, c);
        if (r == 0) f->audit.force[c] = 0; /* of the last step, where one is taken several times */
        f->audit.force[c] += physics_rk3_alpha[r] * flux + physics_rk3_beta[r] * f->audit.flux[c];
        f->audit.flux[c] = flux;
    }
}

/* gamma nu lap u + b nu lap (u* - u), b = length2/(dt nu). */
void fluid_audit_diffusion(struct fluid *f, int r) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const double *const next[3] = {f->predicted[0], f->predicted[1], f->predicted[2]};
    const double nu = f->in.viscosity, b = fluid_diffusion_length2(f, r, 1) / nu;
    const struct flux_kind before = {0, (physics_rk3_gamma[r] - b) * nu}, after = {0, b * nu};
    fluid_predicted_refresh(f, 1);
    for (int c = 0; c < 3; c++) f->audit.force[c] += flux_force(f, q, before, c) + flux_force(f, next, after, c);
}

void fluid_audit_pressure_part(struct fluid *f, int r, double sign) {
    for (int c = 0; c < 3; c++) f->audit.force[c] += sign * physics_rk3_gamma[r] * pressure_force(f, c);
}

void fluid_audit_pressure(struct fluid *f, int r) {
    for (int c = 0; c < 3; c++)
        f->audit.force[c] += physics_rk3_gamma[r] * (pressure_force(f, c) + source_force(f, c, f->state.driving));
}

void fluid_audit_end(struct fluid *f, double out[3]) {
    f->audit.on = 0;
    for (int c = 0; c < 3; c++) out[c] = f->audit.force[c];
    par_sum_array(out, 3);
}
