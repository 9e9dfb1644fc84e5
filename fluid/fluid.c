/* Creates and frees the fluid, gives access to its state, and steps it without immersed bodies. */
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/momentum/correction.h"
#include "fluid/momentum/diffusion.h"
#include "fluid/momentum/momentum.h"
#include "fluid/momentum/planes.h"
#include "fluid/poisson/poisson.h"
#include "fluid/poisson/wisdom.h"
#include "fluid/scheme.h"

#include <stdlib.h>

/* Scratch of a stage: fluxes until all planes are predicted, then what ranks exchange to solve for the columns, then
 * the correction. */
static size_t scratch_of(const struct fluid_grid *g) {
    const size_t flux = fluid_momentum_work(g), correction = fluid_correction_work(g);
    return flux > correction ? flux : correction;
}

static struct fluid_poisson *new_poisson(const struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    struct fluid_poisson_input in = {.row = g->row, .work = f->flux, .capacity = scratch_of(g)};
    for (int d = 0; d < 3; d++) {
        in.n[d] = g->n[d];
        in.d[d] = g->d[d];
        in.ranks[d] = g->ranks[d];
        in.cut[d] = g->cut[d];
        for (int side = 0; side < 2; side++)
            in.end[d][side] = g->periodic[d] ? FLUID_END_PERIODIC : fluid_boundary_end(f->boundary, d, side, 3);
    }
    return fluid_poisson_new(&in);
}

static void check_driving(const struct fluid_input *in) {
    const int d = in->driving.direction;
    if (in->driving.type == FLUID_DRIVING_BULK && in->side[d][0].type != FLUID_PERIODIC)
        die_all(EXIT_CODE_SCENE,
                "fluid.driving: a bulk velocity can be held only in a periodic direction, and %c is not", "xyz"[d]);
}

/* Whether u* needs arrays of its own: implicit diffusion solves for its change, and an open side's faces are advanced
 * after the inner faces. */
static int needs_own_arrays(const struct fluid *f) { return f->in.implicit || f->boundary->open; }

/* Whether the momentum equation has a pressure of its own, pi: only a forcing changes u* between prediction and
 * projection, implicit diffusion has its own rule for p, and projections of whole steps all have the same length. */
static int has_predictor(const struct fluid_input *in) {
    return in->immersed && !in->implicit && in->projection == FLUID_EACH_STAGE;
}

struct fluid *fluid_new(const struct fluid_input *in) {
    struct fluid *f = calloc(1, sizeof *f);
    int periodic[3];
    ENSURE(!in->implicit || in->projection == FLUID_EACH_STAGE, "implicit diffusion with one projection a step");
    f->in = *in;
    f->in.mean_pressure = in->mean_pressure && has_predictor(in);
    fluid_scheme_set(f, FLUID_RK3);
    check_driving(in);
    for (int d = 0; d < 3; d++)
        periodic[d] = in->side[d][0].type == FLUID_PERIODIC && in->side[d][1].type == FLUID_PERIODIC;
    f->grid = fluid_grid_new(in->n, in->length, periodic, in->immersed ? 3 : 1, in->weight);
    f->boundary = fluid_boundary_new(f->grid, in);
    double **arrays[] = {&f->state.u,       &f->state.v,       &f->state.w,      &f->state.p,
                         &f->state.rate[0], &f->state.rate[1], &f->state.rate[2]};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        *arrays[i] = memory_new(MEMORY_FLUID, f->grid->size, sizeof(double));
    f->state.pi = has_predictor(in) ? memory_new(MEMORY_FLUID, f->grid->size, sizeof(double)) : f->state.p;
    for (int c = 0; c < 3; c++)
        f->predicted[c] = needs_own_arrays(f) ? memory_new(MEMORY_FLUID, f->grid->size, sizeof(double))
                                              : fluid_component(&f->state, c);
    f->flux = f->correction = memory_new_work(MEMORY_FLUID, scratch_of(f->grid));
    f->planes = fluid_planes_new(f);
    const enum clock_phase phase = clock_phase(CLOCK_PHASE_PLANS);
    fluid_wisdom_load();
    f->poisson = new_poisson(f);
    if (in->implicit) f->diffusion = fluid_diffusion_new(f);
    fluid_wisdom_store();
    clock_phase(phase);
    if (in->driving.type == FLUID_DRIVING_GRADIENT) f->state.driving = f->state.driven = in->driving.value;
    fluid_initial_fill(f);
    fluid_project_start(f);
    return f;
}

void fluid_free(struct fluid *f) {
    if (!f) return;
    for (int c = 0; c < 3; c++) {
        if (needs_own_arrays(f)) memory_free(f->predicted[c]);
        MEMORY_FREE(fluid_component(&f->state, c), f->state.rate[c]);
    }
    if (has_predictor(&f->in)) memory_free(f->state.pi);
    MEMORY_FREE(f->state.p, f->correction);
    fluid_planes_free(f->planes);
    fluid_poisson_free(f->poisson);
    fluid_diffusion_free(f->diffusion);
    fluid_volume_source_free(f->source);
    fluid_boundary_free(f->boundary);
    fluid_grid_free(f->grid);
    free(f);
}

const struct fluid_input *fluid_input_of(const struct fluid *f) { return &f->in; }
size_t fluid_cells(const struct fluid *f) { return fluid_grid_cells(f->grid); }

int fluid_is_joined(const struct fluid *f) { return f->planes != NULL; }

void fluid_step(struct fluid *f, double dt) {
    for (int r = 0; r < f->scheme.stages; r++) {
        fluid_predict_begin(f, r, dt);
        fluid_diffusion_stage(f, r, dt);
        fluid_project(f, r, dt);
    }
    f->state.t += dt;
}
