/* Predictor of a Runge-Kutta stage: u* from the explicit momentum equation.  (001: eqs 3.70, 3.74) */
#include "base/clock.h"
#include "base/par_halo.h"
#include "fluid/grid/boundary.h"
#include "fluid/grid/outflow.h"
#include "fluid/internal.h"
#include "fluid/momentum/momentum.h"
#include "fluid/momentum/planes.h"

#include <math.h>

/* The number of faces advanced: a side's own face is not advanced with the inner ones. */
static void count_faces(const struct fluid_grid *g, int faces[3]) {
    for (int d = 0; d < 3; d++) faces[d] = g->m[d] - par_halo_at_side(g->halos, d, 1);
}

/* A gradient that depends on time is replaced over a stage by its mean, so that its impulse is exact and the scheme
 * keeps its order: the mean of cos w t from a to b is cos(w (a + b)/2) sin(h)/h, h = w (b - a)/2. */
static void driving_of_stage(struct fluid *f, int r, double dt) {
    const struct fluid_driving *d = &f->in.driving;
    double begin = f->state.t;
    if (d->type != FLUID_DRIVING_GRADIENT || !(f->in.driving_frequency > 0)) return;
    for (int s = 0; s < r; s++) begin += f->scheme.gamma[s] * dt;
    const double w = 2 * M_PI * f->in.driving_frequency, half = 0.5 * f->scheme.gamma[r] * dt, h = w * half;
    f->state.driving = d->value * cos(w * (begin + half)) * (h > 0 ? sin(h) / h : 1);
}

/* The stage for the faces on open sides: those that read R of the step before do not (fluid/scheme.h). */
static struct fluid_momentum_stage of_side(const struct fluid *f, struct fluid_momentum_stage s) {
    if (!f->scheme.is_multistep) return s;
    s.a = s.c;
    s.b = 0;
    return s;
}

/* What comes before the momentum pass of stage r. */
static struct fluid_momentum_stage begin_stage(struct fluid *f, int r, double dt) {
    const struct fluid_grid *g = f->grid;
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    struct fluid_momentum_stage s = {.grid = g,
                                     .a = dt * f->scheme.alpha[r],
                                     .b = dt * f->scheme.beta[r],
                                     .c = dt * f->scheme.gamma[r],
                                     .store_rate = r + 1 < f->scheme.stages || f->scheme.is_multistep,
                                     .viscosity = f->in.implicit ? 0 : f->in.viscosity,
                                     .inverse_density = 1 / f->in.density,
                                     .work = f->flux};
    count_faces(g, s.faces);
    driving_of_stage(f, r, dt);
    for (int d = 0; d < 3; d++) s.source[d] = fluid_source(f, d);
    if (r == 0) fluid_outflow_begin(f->boundary, g, q);
    const struct fluid_momentum_stage side = of_side(f, s);
    /* before u* overwrites u, if they are one array */
    fluid_outflow_advance(f->boundary, g, q, f->state.rate, side.a, side.b);
    return s;
}

static void predict(struct fluid *f, const struct fluid_momentum_stage *s) {
    const double *const read[3] = {f->state.u, f->state.v, f->state.w};
    const struct fluid_momentum_stage stage = of_side(f, *s);
    fluid_momentum_predict(s, read, f->state.pi, f->predicted, f->state.rate);
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *b = &f->boundary->side[d][side];
            if (!b->here || b->normal != FLUID_NORMAL_FREE) continue;
            fluid_momentum_open_predict(&stage, d, side, b->drains, read, f->state.pi, f->predicted, f->state.rate);
            for (int c = 0; c < 3; c++) {
                int low[3], high[3];
                fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
                if (c != d && fluid_boundary_is_open(b, d, c))
                    fluid_momentum_open_incoming(s, d, side, c, low, high, read, f->predicted, f->state.rate);
            }
        }
    const struct par_halo_part whole = par_halo_whole(f->grid->halos, 1);
    fluid_boundary_faces(f->boundary, f->grid, f->predicted, &whole);
}

/* Stage r, with the momentum pass over all planes or the beginning of the one by groups of planes. */
static void run_stage(struct fluid *f, int r, double dt,
                      void (*pass)(struct fluid *f, const struct fluid_momentum_stage *s)) {
    if (r == 0) fluid_scheme_begin(f, dt);
    if (f->box_balance.on) fluid_box_force_flux(f, r);
    clock_begin(CLOCK_MOMENTUM);
    const struct fluid_momentum_stage s = begin_stage(f, r, dt);
    pass(f, &s);
    if (f->box_balance.on) fluid_box_force_open(f, r);
    clock_end(CLOCK_MOMENTUM);
}

void fluid_predict(struct fluid *f, int r, double dt) { run_stage(f, r, dt, predict); }

void fluid_predict_begin(struct fluid *f, int r, double dt) {
    run_stage(f, r, dt, f->planes && fluid_stage_share(f, r) > 0 ? fluid_planes_begin : predict);
}
