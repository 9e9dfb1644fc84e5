/* Force on the box of the flow: momentum through its sides, pressure and sources, of a state and of a whole step. */
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/measure/side_flux.h"
#include "fluid/momentum/diffusion.h"

#include <limits.h>
#include <math.h>

static double cell_volume(const struct fluid_grid *g) { return g->d[0] * g->d[1] * g->d[2]; }

/* Pressure over density on the control surface of component d at one side of its direction, times the outward sign,
 * m2/s2. */
static double pressure_on_side(const struct fluid *f, int d, int side) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t up = side ? fluid_boundary_stride(g, d) : 0;
    int low[3], high[3], at[3];
    double sum = 0;
    fluid_side_flux_faces(f, d, d, side, low, high);
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++)
                sum += f->state.p[(ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]) + up];
    return (side ? 1 : -1) * sum / f->in.density;
}

/* This rank's share of the force of the fluxes on the box along c, N. Adds their couple, N m, unless it is NULL. */
static double flux_force(const struct fluid *f, const double *const q[3], struct fluid_flux_kind kind, int c,
                         double couple[3]) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            if (!f->boundary->side[d][side].here) continue;
            const struct fluid_side_flux flux = fluid_side_flux(f, q, kind, c, d, side);
            sum -= flux.sum / g->d[d];
            if (couple) fluid_box_couple_side(f, &flux, c, d, side, couple);
        }
    return f->in.density * cell_volume(g) * sum;
}

static double source_force(const struct fluid *f, int c) {
    int low[3], high[3];
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    const double faces = (double)(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    return f->in.density * cell_volume(f->grid) * faces * fluid_source(f, c);
}

/* Of both sides across c. Adds `share` times the sum of the sizes of their forces, N, unless size is NULL. */
static double pressure_force(const struct fluid *f, int c, double share, double *size) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int side = 0; side < 2; side++) {
        if (!f->boundary->side[c][side].here) continue;
        const double force = pressure_on_side(f, c, side) / g->d[c];
        sum -= force;
        if (size) *size += share * f->in.density * cell_volume(g) * fabs(force);
    }
    return f->in.density * cell_volume(g) * sum;
}

void fluid_box_force(struct fluid *f, double out[3]) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct fluid_flux_kind whole = {1, f->in.viscosity};
    for (int c = 0; c < 3; c++)
        out[c] = flux_force(f, q, whole, c, NULL) + source_force(f, c) + pressure_force(f, c, 1, NULL);
    par_sum_array(out, 3);
}

void fluid_box_force_begin(struct fluid *f) { f->box_balance = (struct fluid_box_balance){.on = 1}; }

/* The sum of R over the advanced faces (0), or over those of them on free sides (1), as a force, N. The first one was
 * the flux through the sides when R was computed, but for round-off. */
static double rate_force(const struct fluid *f, int c, int on_free_sides) {
    const struct fluid_grid *g = f->grid;
    int low[3], high[3], at[3];
    double sum = 0;
    fluid_boundary_advanced(f->boundary, g, c, low, high);
    const struct fluid_boundary_side *side = f->boundary->side[c];
    const int free_low = side[0].here && side[0].normal == FLUID_NORMAL_FREE ? low[c] : INT_MIN,
              free_high = side[1].here && side[1].normal == FLUID_NORMAL_FREE ? high[c] - 1 : INT_MIN;
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++) {
            const double *row = f->state.rate[c] + fluid_grid_at(g, 0, at[1], at[2]);
            for (at[0] = low[0]; at[0] < high[0]; at[0]++) {
                const int is_free = at[c] == free_low || at[c] == free_high;
                sum += is_free == on_free_sides ? row[at[0]] : 0;
            }
        }
    return f->in.density * cell_volume(g) * sum;
}

void fluid_box_force_flux(struct fluid *f, int r) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct fluid_flux_kind kind = {1, f->diffusion ? 0 : f->in.viscosity};
    double couple[3] = {0, 0, 0};
    if (r == 0) f->box_balance.size = 0;
    for (int c = 0; c < 3; c++) {
        const double flux = flux_force(f, q, kind, c, couple);
        if (r == 0) f->box_balance.force[c] = 0; /* of the last step only, if several are taken */
        if (r == 0 && f->scheme.beta[r] != 0) f->box_balance.flux[c] = rate_force(f, c, 0);
        f->box_balance.force[c] += f->scheme.alpha[r] * flux + f->scheme.beta[r] * f->box_balance.flux[c];
        f->box_balance.flux[c] = flux;
    }
    fluid_box_couple_periods(f, q, couple);
    for (int c = 0; c < 3; c++) {
        if (r == 0) f->box_balance.couple[c] = 0;
        f->box_balance.couple[c] += f->scheme.alpha[r] * couple[c] + f->scheme.beta[r] * f->box_balance.flux_couple[c];
        f->box_balance.flux_couple[c] = couple[c];
    }
}

/* Faces on free sides take gamma R in place of alpha R + beta R_old. */
void fluid_box_force_open(struct fluid *f, int r) {
    if (!f->scheme.is_multistep || f->scheme.beta[r] == 0 || !f->boundary->open) return;
    for (int c = 0; c < 3; c++) f->box_balance.force[c] += f->scheme.beta[r] * rate_force(f, c, 1);
}

/* gamma nu lap u + b nu lap (u* - u), b = length2/(dt nu). */
void fluid_box_force_diffusion(struct fluid *f, int r) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const double *const next[3] = {f->predicted[0], f->predicted[1], f->predicted[2]};
    const double nu = f->in.viscosity, b = fluid_diffusion_length2(f, r, 1) / nu;
    const struct fluid_flux_kind before = {0, (f->scheme.gamma[r] - b) * nu}, after = {0, b * nu};
    fluid_predicted_refresh(f, 1);
    for (int c = 0; c < 3; c++)
        f->box_balance.force[c] += flux_force(f, q, before, c, NULL) + flux_force(f, next, after, c, NULL);
}

void fluid_box_force_close(struct fluid *f, int r) {
    if (!f->box_balance.on) return;
    fluid_box_force_diffusion(f, r);
    f->box_balance.has_diffusion = 1;
}

void fluid_box_force_pressure_part(struct fluid *f, int r, double sign) {
    for (int c = 0; c < 3; c++) f->box_balance.force[c] += sign * f->scheme.gamma[r] * pressure_force(f, c, 1, NULL);
}

void fluid_box_force_pressure(struct fluid *f, int r) {
    const int is_mean = f->in.mean_pressure; /* once the last stage is done */
    const double share = is_mean ? r == f->scheme.stages - 1 : fluid_stage_share(f, r),
                 source = fluid_stage_share_driven(f, r);
    for (int c = 0; c < 3; c++) {
        double *size = &f->box_balance.size;
        const double by_source = source * source_force(f, c);
        f->box_balance.force[c] += (share > 0 ? share * pressure_force(f, c, share, size) : 0) + by_source;
        *size += fabs(by_source);
    }
    if (share > 0) fluid_box_couple_pressure(f, share, f->box_balance.couple);
    fluid_box_couple_source(f, source, f->box_balance.couple);
}

void fluid_box_force_end(struct fluid *f, double out[3]) {
    f->box_balance.on = 0;
    for (int c = 0; c < 3; c++) out[c] = f->box_balance.force[c];
    par_sum_array(out, 3);
}

double fluid_box_force_size(const struct fluid *f) { return par_sum(f->box_balance.size); }
