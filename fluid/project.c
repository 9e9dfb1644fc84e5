#include "base/clock.h"
#include "base/par.h"
#include "fluid/correction.h"
#include "fluid/internal.h"
#include "fluid/momentum.h"
#include "fluid/outflow.h"

#include <string.h>

/* u* on the low faces of this rank's cells, which belong to the cells before them: all that its divergence reads of ghosts. */
static void low_faces(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const struct par_halo_part low = {.layers = 1,
                                      .high = {g->m[0], g->m[1], g->m[2]},
                                      .wanted = {{1, 0}, {1, 0}, {1, 0}},
                                      .asked = {{0, 1}, {0, 1}, {0, 1}}};
    const struct par_halo_part whole = par_halo_whole(g->halos, 1);
    if (f->in.immersed) fluid_boundary_faces(f->boundary, g, f->predicted, &whole); /* after a forcing */
    for (int d = 0; d < 3; d++) par_halo_fill_part(g->halos, d, 1, &f->predicted[d], &low);
}

/* The right-hand side, and what can be done with each of its planes alone. */
static void divergence(struct fluid *f, double c) {
    const double *const predicted[3] = {f->predicted[0], f->predicted[1], f->predicted[2]};
    for (int k = 0; k < f->grid->m[2]; k++) {
        fluid_momentum_divergence(f->grid, k, 1 / c, predicted, fluid_poisson_plane(f->poisson, k));
        fluid_poisson_plane_forward(f->poisson, k);
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
 * cells is made zero, so that what is immersed is squeezed by what stands above the outlet, and by nothing else. The mean
 * that the correction must have for it. */
static double level(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const struct fluid_side *side = f->in.side[0];
    if (side[0].type != FLUID_OUTFLOW && side[1].type != FLUID_OUTFLOW) return 0;
    if (f->boundary->open) return 0; /* fixed by that side's pressure */
    const int last = side[1].type == FLUID_OUTFLOW, i = last ? g->m[0] - 1 : 0;
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) sum += f->state.p[fluid_grid_at(g, i, j, k)];
    return -par_sum(sum / ((double)g->n[1] * g->n[2]) + fluid_poisson_section_mean(f->poisson, last));
}

/* phi with lap phi = div(u*)/c, q = u* - c grad phi + shift, p += phi.  (001: eqs 3.71-3.73) */
static void project(struct fluid *f, double c, int fix_level) {
    low_faces(f);
    clock_begin(CLOCK_FORWARD);
    divergence(f, c);
    clock_end(CLOCK_FORWARD);
    clock_begin(CLOCK_COLUMNS);
    fluid_poisson_solve(f->poisson, fix_level ? level(f) : 0);
    clock_end(CLOCK_COLUMNS);
    clock_begin(CLOCK_BACKWARD);
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    fluid_correction_apply(f, c, q);
    clock_end(CLOCK_BACKWARD);
    fluid_boundary_velocity(f->boundary, f->grid, q, 1);
}

void fluid_project(struct fluid *f, int r, double dt) {
    const double stage = fluid_gamma[r] * dt;
    clock_begin(CLOCK_POISSON);
    if (f->in.driving.type == FLUID_DRIVING_BULK) hold_bulk(f, stage);
    project(f, stage / f->in.density, r == 2);
    if (f->audit.on) fluid_audit_pressure(f, r);
    clock_end(CLOCK_POISSON);
}

/* The initial velocity made to obey the sides and continuity, before anything has moved. */
void fluid_project_start(struct fluid *f) {
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    fluid_outflow_advance(f->boundary, f->grid, q, f->rate, 0,
                          0); /* speeds are still zero: only mass is mended */
    for (int c = 0; c < 3 && f->predicted[c] != q[c]; c++)
        memcpy(f->predicted[c], q[c], f->grid->size * sizeof(double));
    fluid_predicted_refresh(f, 1);
    project(f, 1, 0);
    memset(f->state.p, 0, f->grid->size * sizeof(double));
    fluid_state_refresh(f);
}
