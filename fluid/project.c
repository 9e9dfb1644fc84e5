#include "base/clock.h"
#include "base/par.h"
#include "fluid/internal.h"
#include "fluid/momentum.h"
#include "fluid/outflow.h"

#include <string.h>

/* phi with lap phi = div(predicted)/c, q = predicted - c grad phi + shift, p += phi.  (001: eqs 3.71-3.73) */
static void project(struct fluid *f, double c) {
    const struct fluid_grid *g = f->grid;
    double *const q[3] = {f->state.u, f->state.v, f->state.w}, *phi = f->correction;
    const double *const predicted[3] = {f->predicted[0], f->predicted[1], f->predicted[2]};
    for (int k = 0; k < g->m[2]; k++) {
        fluid_momentum_divergence(g, k, 1 / c, predicted, fluid_poisson_plane(f->poisson, k));
        fluid_poisson_plane_forward(f->poisson, k);
    }
    fluid_poisson_solve(f->poisson, phi + fluid_grid_at(g, 0, 0, 0));
    fluid_boundary_pressure(f->boundary, g, phi, 1, 1);
    fluid_momentum_correct(g, c, f->shift, phi, predicted, q, f->state.p);
    for (int d = 0; d < 3; d++) { /* free low faces, which no array owns */
        const struct fluid_boundary_side *s = &f->boundary->side[d][0];
        int a, b;
        fluid_boundary_others(d, &a, &b);
        if (!s->here || s->normal != FLUID_NORMAL_FREE) continue;
        for (int l = 0; l < g->m[b]; l++)
            for (int j = 0; j < g->m[a]; j++) {
                const size_t n = fluid_boundary_face(g, d, 0, j, l),
                             inside = n + (size_t)fluid_boundary_stride(g, d);
                q[d][n] = predicted[d][n] - c / g->d[d] * (phi[inside] - phi[n]) + f->shift[d];
            }
    }
    fluid_boundary_velocity(f->boundary, g, q, 1);
}

/* Ghosts of p next to the cells, which the correction of the cells has left behind. */
static void add_ghosts(const struct fluid_grid *g, const double *phi, double *p) {
    const int *m = g->m;
    for (int k = -1; k <= m[2]; k++)
        for (int j = -1; j <= m[1]; j++) {
            const size_t n = fluid_grid_at(g, 0, j, k);
            const int inside = k >= 0 && k < m[2] && j >= 0 && j < m[1];
            p[n - 1] += phi[n - 1];
            p[n + (size_t)m[0]] += phi[n + (size_t)m[0]];
            for (int i = 0; i < m[0] && !inside; i++) p[n + (size_t)i] += phi[n + (size_t)i];
        }
}

/* The uniform velocity that brings the bulk back to its value, as a change of the driving over this stage: the gradient that
 * would have done so replaces it. */
static void hold_bulk(struct fluid *f, double stage) {
    const struct fluid_grid *g = f->grid;
    const int d = f->in.driving.direction;
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double *row = f->predicted[d] + fluid_grid_at(g, 0, j, k);
            double part = 0;
            for (int i = 0; i < g->m[0]; i++) part += row[i];
            sum += part;
        }
    f->shift[d] = f->in.driving.value - par_sum(sum) / (double)fluid_cells(f);
    f->state.driving += f->in.density * f->shift[d] / stage;
}

/* With velocities given on every side the pressure is known up to a constant: where the flow leaves, its mean over the last
 * cells is made zero, so that what is immersed is squeezed by what stands above the outlet, and by nothing else. */
static void fix_level(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const struct fluid_side *side = f->in.side[0];
    if (side[0].type != FLUID_OUTFLOW && side[1].type != FLUID_OUTFLOW) return;
    const int i = side[1].type == FLUID_OUTFLOW ? g->m[0] - 1 : 0;
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) sum += f->state.p[fluid_grid_at(g, i, j, k)];
    const double level = par_sum(sum) / ((double)g->n[1] * g->n[2]);
    for (size_t n = 0; n < g->size; n++) f->state.p[n] -= level;
}

void fluid_project(struct fluid *f, int r, double dt) {
    const double stage = fluid_gamma[r] * dt;
    clock_begin(CLOCK_POISSON);
    if (f->in.immersed) fluid_predicted_refresh(f, 1); /* a forcing has changed it */
    if (f->in.driving.type == FLUID_DRIVING_BULK) hold_bulk(f, stage);
    project(f, stage / f->in.density);
    add_ghosts(f->grid, f->correction, f->state.p);
    if (f->audit.on) fluid_audit_pressure(f, r);
    if (r == 2) fix_level(f);
    clock_end(CLOCK_POISSON);
}

/* The initial velocity made to obey the sides and continuity, before anything has moved. */
void fluid_project_start(struct fluid *f) {
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    fluid_outflow_advance(f->boundary, f->grid, q, f->rate, 0,
                          0); /* speeds are still zero: only mass is mended */
    for (int c = 0; c < 3; c++) memcpy(f->predicted[c], q[c], f->grid->size * sizeof(double));
    fluid_predicted_refresh(f, 1);
    project(f, 1);
    memset(f->state.p, 0, f->grid->size * sizeof(double));
    fluid_state_refresh(f);
}
