/* Force on the box of the flow: momentum through its sides, pressure and sources, of a state and of a whole step. */
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/momentum/diffusion.h"

#include <limits.h>

static double cell_volume(const struct fluid_grid *g) { return g->d[0] * g->d[1] * g->d[2]; }

/* The faces of component c next to one side of direction d, as fluid_boundary_advanced gives them. */
static void beside(const struct fluid *f, int c, int d, int side, int low[3], int high[3]) {
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    low[d] = side ? high[d] - 1 : low[d];
    high[d] = low[d] + 1;
}

/* Which terms of the flux count: convection (1 or 0), and diffusion with this viscosity. */
struct flux_kind {
    double convection, viscosity; /* 1; m2/s */
};

enum { AHEAD = 12 }; /* faces of a column */

/* How the flux of one line of faces beside a side is summed. */
struct line {
    int normal, free_face;              /* c == d; fluid_boundary_is_open */
    int drains;                         /* as fluid_boundary_side */
    int side;                           /* 0 low, 1 high */
    ptrdiff_t s, sd, sc;                /* strides: towards the outside; of d; of c */
    double convection, sign, nu_over_d; /* 1; outward; m/s */
};

/* The flux of face i of the line, m2/s2. */
static inline __attribute__((always_inline)) double flux_of_face(const struct line *l, const double *q,
                                                                 const double *face, const int normal, const int free) {
    const double here = q[0], beyond = q[l->s], mean = 0.5 * (here + beyond);
    if (normal && free) return l->convection * l->sign * fluid_boundary_open_flux(here, q[-l->s], l->sign, l->drains);
    if (normal) /* at the centre between the last advanced face and the side's own */
        return l->convection * l->sign * mean * mean - l->nu_over_d * (beyond - here);
    const double velocity = 0.5 * (face[0] + face[l->sc]); /* at the corners on the side's face */
    const double carried = free && fluid_boundary_comes_in(velocity, l->sign) ? 0 : mean;
    return l->convection * l->sign * velocity * carried - l->nu_over_d * (beyond - here);
}

/* The flux of n faces from q on, `step` apart, m2/s2. The cache lines of a column are prefetched. */
static inline __attribute__((always_inline)) double flux_of_line(const struct line *l, const double *q,
                                                                 const double *through, int n, ptrdiff_t step,
                                                                 const int normal, const int free) {
    const double *face = l->side ? through : through - l->sd;
    double sum = 0;
    if (step == 1) {
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < n; i++) sum += flux_of_face(l, q + i, face + i, normal, free);
        return sum;
    }
    for (int i = 0; i < n; i++, q += step, face += step) {
        __builtin_prefetch(q + AHEAD * step);
        __builtin_prefetch(q + AHEAD * step + l->s);
        if (!normal) __builtin_prefetch(face + AHEAD * step);
        sum += flux_of_face(l, q, face, normal, free);
    }
    return sum;
}

static inline double flux_of(const struct line *l, const double *q, const double *through, int n, ptrdiff_t step) {
    if (l->free_face)
        return l->normal ? flux_of_line(l, q, through, n, step, 1, 1) : flux_of_line(l, q, through, n, step, 0, 1);
    return l->normal ? flux_of_line(l, q, through, n, step, 1, 0) : flux_of_line(l, q, through, n, step, 0, 0);
}

/* Flux of momentum of component c out of the control surface at one side of direction d, less the viscous traction:
 * (q_d q_c - nu dq_c/dx_d) times the outward sign, summed over the side, m2/s2. A side across x is summed by columns
 * along y. */
static double flux_through_side(const struct fluid *f, const double *const all[3], struct flux_kind kind, int c, int d,
                                int side) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t sd = fluid_boundary_stride(g, d);
    const struct line line = {.normal = c == d,
                              .free_face = fluid_boundary_is_open(&f->boundary->side[d][side], d, c),
                              .drains = f->boundary->side[d][side].drains,
                              .side = side,
                              .s = side ? sd : -sd,
                              .sd = sd,
                              .sc = fluid_boundary_stride(g, c),
                              .convection = kind.convection,
                              .sign = side ? 1 : -1,
                              .nu_over_d = kind.viscosity / g->d[d]};
    int low[3], high[3];
    double sum = 0;
    beside(f, c, d, side, low, high);
    for (int k = low[2]; k < high[2]; k++) {
        if (d == 0) {
            const size_t n = fluid_grid_at(g, low[0], low[1], k);
            sum += flux_of(&line, all[c] + n, all[d] + n, high[1] - low[1], g->row);
            continue;
        }
        for (int j = low[1]; j < high[1]; j++) {
            const size_t n = fluid_grid_at(g, low[0], j, k);
            sum += flux_of(&line, all[c] + n, all[d] + n, high[0] - low[0], 1);
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

/* This rank's share of the force on the box along c, N: sources and fluxes. */
static double flux_force(const struct fluid *f, const double *const q[3], struct flux_kind kind, int c) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (f->boundary->side[d][side].here) sum -= flux_through_side(f, q, kind, c, d, side) / g->d[d];
    return f->in.density * cell_volume(g) * sum;
}

static double source_force(const struct fluid *f, int c) {
    int low[3], high[3];
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    const double faces = (double)(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    return f->in.density * cell_volume(f->grid) * faces * fluid_source(f, c);
}

static double pressure_force(const struct fluid *f, int c) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int side = 0; side < 2; side++)
        if (f->boundary->side[c][side].here) sum -= pressure_on_side(f, c, side) / g->d[c];
    return f->in.density * cell_volume(g) * sum;
}

void fluid_box_force(struct fluid *f, double out[3]) {
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct flux_kind whole = {1, f->in.viscosity};
    for (int c = 0; c < 3; c++) out[c] = flux_force(f, q, whole, c) + source_force(f, c) + pressure_force(f, c);
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
    const struct flux_kind kind = {1, f->diffusion ? 0 : f->in.viscosity};
    for (int c = 0; c < 3; c++) {
        const double flux = flux_force(f, q, kind, c);
        if (r == 0) f->box_balance.force[c] = 0; /* of the last step only, if several are taken */
        if (r == 0 && f->scheme.beta[r] != 0) f->box_balance.flux[c] = rate_force(f, c, 0);
        f->box_balance.force[c] += f->scheme.alpha[r] * flux + f->scheme.beta[r] * f->box_balance.flux[c];
        f->box_balance.flux[c] = flux;
    }
    double couple[3] = {0, 0, 0};
    fluid_box_couple_flux(f, q, couple);
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
    const struct flux_kind before = {0, (f->scheme.gamma[r] - b) * nu}, after = {0, b * nu};
    fluid_predicted_refresh(f, 1);
    for (int c = 0; c < 3; c++) f->box_balance.force[c] += flux_force(f, q, before, c) + flux_force(f, next, after, c);
}

void fluid_box_force_close(struct fluid *f, int r) {
    if (!f->box_balance.on) return;
    fluid_box_force_diffusion(f, r);
    f->box_balance.has_diffusion = 1;
}

void fluid_box_force_pressure_part(struct fluid *f, int r, double sign) {
    for (int c = 0; c < 3; c++) f->box_balance.force[c] += sign * f->scheme.gamma[r] * pressure_force(f, c);
}

void fluid_box_force_pressure(struct fluid *f, int r) {
    const int is_mean = f->in.mean_pressure; /* once the last stage is done */
    const double share = is_mean ? r == f->scheme.stages - 1 : fluid_stage_share(f, r),
                 source = fluid_stage_share_driven(f, r);
    for (int c = 0; c < 3; c++)
        f->box_balance.force[c] += (share > 0 ? share * pressure_force(f, c) : 0) + source * source_force(f, c);
    if (share > 0) fluid_box_couple_pressure(f, share, f->box_balance.couple);
    fluid_box_couple_source(f, source, f->box_balance.couple);
}

void fluid_box_force_end(struct fluid *f, double out[3]) {
    f->box_balance.on = 0;
    for (int c = 0; c < 3; c++) out[c] = f->box_balance.force[c];
    par_sum_array(out, 3);
}
