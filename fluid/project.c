/* Projection of a stage: pressure solve, divergence-free velocity, new pressure.  (001: eqs 3.71-3.73) */
#include "base/clock.h"
#include "base/par.h"
#include "base/par_halo.h"
#include "base/threads.h"
#include "base/vec.h"
#include "fluid/grid/boundary.h"
#include "fluid/grid/outflow.h"
#include "fluid/internal.h"
#include "fluid/momentum/correction.h"
#include "fluid/momentum/diffusion.h"
#include "fluid/momentum/momentum.h"
#include "fluid/momentum/planes.h"
#include "fluid/poisson/poisson.h"

#include <string.h>

/* Sets u* on the low faces of the first cells along a direction, in planes first .. last-1; they are stored in ghost
 * cells. The divergence reads no other ghosts. */
static void low_faces(struct fluid *f, int direction, int first, int last) {
    const struct fluid_grid *g = f->grid;
    if (!g->periodic[direction] && g->ranks[direction] == 1) return;
    const struct par_halo_part low = {.layers = 1,
                                      .low = {0, 0, first},
                                      .high = {g->m[0], g->m[1], last},
                                      .wanted = {{1, 0}, {1, 0}, {1, 0}},
                                      .asked = {{0, 1}, {0, 1}, {0, 1}}};
    par_halo_fill_part(g->halos, direction, 1, &f->predicted[direction], &low);
}

/* This rank's sum of the driven component over plane k. */
static double bulk_of(const struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    const int whole = g->m[0] / VEC_LANES * VEC_LANES;
    vec lanes = vec_set(0);
    double sum = 0;
    for (int j = 0; j < g->m[1]; j++) {
        const double *row = f->predicted[f->in.driving.direction] + fluid_grid_at(g, 0, j, k);
        for (int i = 0; i < whole; i += VEC_LANES) lanes += vec_load(row + i);
        for (int i = whole; i < g->m[0]; i++) sum += row[i];
    }
    return sum + vec_sum(lanes);
}

static void add_to_pressure(struct fluid *f, int k, double factor, const double *plane) {
    const struct fluid_grid *g = f->grid;
    for (int j = 0; j < g->m[1]; j++) {
        double *p = f->state.p + fluid_grid_at(g, 0, j, k);
        for (int i = 0; i < g->m[0]; i++) p[i] += factor * plane[j * g->m[0] + i];
    }
}

/* Arguments of the threads that compute the right-hand side plane by plane. */
struct right_side {
    struct fluid *f;
    double c, length2;
    double bulk[THREADS_MAX]; /* of each thread's planes */
};

static void fill(void *data, int k, double *divergence) {
    struct right_side *r = data;
    struct fluid *f = r->f;
    const double *const predicted[3] = {f->predicted[0], f->predicted[1], f->predicted[2]};
    if (fluid_planes_open(f)) fluid_planes_predict(f, k);
    low_faces(f, 0, k, k + 1);
    if (f->grid->ranks[1] == 1) low_faces(f, 1, k, k + 1);
    if (f->in.driving.type == FLUID_DRIVING_BULK) r->bulk[threads_me()] += bulk_of(f, k);
    fluid_momentum_kernels_divergence(f->grid, k, 1 / r->c, predicted, divergence);
    if (f->source) fluid_volume_source_subtract(f, k, 1 / r->c, divergence);
    if (r->length2 > 0) add_to_pressure(f, k, -r->length2, divergence);
}

/* Computes the right-hand side and transforms each of its planes while it is in the cache. Returns this rank's sum of
 * u* along the driving if its mean is to be kept. With implicit diffusion p gets -length2 lap phi, length2 = b dt nu:
 * then p + phi is the pressure that the equation of u* would have needed, and the pressure converges in large steps as
 * well (the rotational form of Timmermans, Minev and van de Vosse 1996). */
static double forward(struct fluid *f, double c, double length2) {
    const struct fluid_grid *g = f->grid;
    const struct par_halo_part whole = par_halo_whole(g->halos, 1);
    struct right_side r = {f, c, length2, {0}};
    double bulk = 0;
    clock_begin(CLOCK_FORWARD);
    if (f->in.immersed) fluid_boundary_faces(f->boundary, g, f->predicted, &whole); /* after a forcing */
    if (!fluid_planes_open(f)) low_faces(f, 2, 0, g->m[2]);
    if (g->ranks[1] > 1) low_faces(f, 1, 0, g->m[2]);
    fluid_poisson_forward(f->poisson, fill, &r);
    for (int t = 0; t < threads_count(); t++) bulk += r.bulk[t];
    clock_end(CLOCK_FORWARD);
    return bulk;
}

/* Finds the uniform velocity that restores the bulk velocity, and sets the driving to the gradient that would have done
 * so over this stage. */
static void hold_bulk(struct fluid *f, double bulk, double stage) {
    const int d = f->in.driving.direction;
    f->shift[d] = f->in.driving.value - par_sum(bulk) / (double)fluid_grid_cells(f->grid);
    f->state.driving += f->in.density * f->shift[d] / stage;
}

/* This rank's share of the mean of pi over the cells at a side. */
static double section_mean(const struct fluid *f, int d, int side) {
    const struct fluid_grid *g = f->grid;
    int a, b;
    double sum = 0;
    if (!f->boundary->side[d][side].here) return 0;
    fluid_boundary_others(d, &a, &b);
    const ptrdiff_t in = side ? 0 : fluid_boundary_stride(g, d);
    for (int l = 0; l < g->m[b]; l++)
        for (int j = 0; j < g->m[a]; j++) sum += f->state.pi[(ptrdiff_t)fluid_boundary_face(g, d, side, j, l) + in];
    return sum / ((double)g->n[a] * g->n[b]);
}

/* With velocities given on every side the pressure is known up to a constant. At an outflow the mean pressure over the
 * last cells is set to zero, so bodies feel the pressure relative to the outlet's. The first of several outlets counts:
 * x before y before z, high before low. Returns the mean that the correction needs for this. */
static double level(struct fluid *f) {
    if (f->boundary->open) return 0; /* fixed by the pressure of that side */
    for (int d = 0; d < 3; d++)
        for (int side = 1; side >= 0; side--)
            if (f->boundary->side[d][side].normal == FLUID_NORMAL_CONVECTIVE)
                return -par_sum(section_mean(f, d, side) + fluid_poisson_section_mean(f->poisson, d, side));
    return 0;
}

static int is_last(const struct fluid *f, int r) { return r == f->scheme.stages - 1; }

static int is_apart(const struct fluid *f) { return f->state.pi != f->state.p; }

/* The pressures that stage r changes. With u -> u + S f between prediction and projection, handing the pressure on
 * unweighted between stages of different lengths creates energy; with the weight |u|^2 + (gamma_1 dt/rho)^2 |grad pi|^2
 * does not grow by it. The pressure that a step leaves is that of its last stage, or the mean sum gamma_r p_r, whose
 * impulse is the step's.  (docs/design/fluid.md) */
static struct fluid_momentum_pressure pressure_of(const struct fluid *f, int r) {
    const double ratio = f->scheme.gamma[r] / f->scheme.most;
    const int is_mean = f->in.mean_pressure, is_read = is_mean || is_last(f, r) || f->box_balance.on;
    return (struct fluid_momentum_pressure){.p = is_apart(f) && !is_read ? NULL : f->state.p,
                                            .pi = f->state.pi,
                                            .weight = is_apart(f) ? ratio * ratio : 1,
                                            .share = is_mean ? f->scheme.gamma[r] : 1,
                                            .is_first = !is_mean || r == 0};
}

/* Solves lap phi = div(u*)/c, then q = u* - c grad phi + shift and the stage's pressures; all planes of the right-hand
 * side have been transformed.  (001: eqs 3.71-3.73) */
static void project(struct fluid *f, int r, double c, int fix_level) {
    clock_begin(CLOCK_COLUMNS);
    fluid_poisson_solve(f->poisson, fix_level ? level(f) : 0);
    clock_end(CLOCK_COLUMNS);
    clock_begin(CLOCK_BACKWARD);
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    const struct fluid_momentum_pressure pressure = pressure_of(f, r);
    fluid_correction_apply(f, c, &pressure, q);
    clock_end(CLOCK_BACKWARD);
}

/* Fills the pressure's ghosts, to which only phi was added so far. */
static void refresh_pressure(struct fluid *f) {
    const struct par_halo_part whole = par_halo_whole(f->grid->halos, 1);
    fluid_boundary_pressure(f->boundary, f->grid, f->state.p, &whole);
}

static void keep_driven(struct fluid *f, int r) {
    f->state.driven = (r == 0 ? 0 : f->state.driven) + fluid_stage_share_driven(f, r) * f->state.driving;
}

/* Makes u* the velocity of the next stage without a projection. Its divergence is of second order in the step, because
 * the pressure of the last step stands for that of this one.  (Aithal and Ferrante 2020) */
static void hand_on(struct fluid *f) {
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    for (int c = 0; c < 3 && f->predicted[c] != q[c]; c++)
        memcpy(q[c], f->predicted[c], f->grid->size * sizeof(double));
    fluid_boundary_velocity(f->boundary, f->grid, q, 1);
}

void fluid_project(struct fluid *f, int r, double dt) {
    const double share = fluid_stage_share(f, r), stage = share * dt;
    clock_begin(CLOCK_POISSON);
    if (!(share > 0)) {
        hand_on(f);
        keep_driven(f, r);
        if (f->box_balance.on) fluid_box_force_pressure(f, r);
        clock_end(CLOCK_POISSON);
        return;
    }
    const double length2 = f->diffusion ? fluid_diffusion_length2(f, r, dt) : 0;
    const int is_split = f->box_balance.on && f->diffusion;
    if (is_split && !f->box_balance.has_diffusion) fluid_box_force_diffusion(f, r);
    f->box_balance.has_diffusion = 0;
    if (is_split) fluid_box_force_pressure_part(f, r, 1);
    const double c = stage / f->in.density, bulk = forward(f, c, length2);
    if (is_split) fluid_box_force_pressure_part(f, r, -1);
    if (f->in.driving.type == FLUID_DRIVING_BULK) hold_bulk(f, bulk, stage);
    keep_driven(f, r);
    project(f, r, c, is_last(f, r) || f->in.mean_pressure);
    if (f->diffusion) refresh_pressure(f);
    if (f->box_balance.on) fluid_box_force_pressure(f, r);
    clock_end(CLOCK_POISSON);
}

/* Makes the initial velocity satisfy the sides' conditions and continuity, before the first step. */
void fluid_project_start(struct fluid *f) {
    double *const q[3] = {f->state.u, f->state.v, f->state.w};
    fluid_outflow_advance(f->boundary, f->grid, q, f->state.rate, 0, 0); /* with a step of zero: only the mass balance
                                                                          * is corrected */
    for (int c = 0; c < 3 && f->predicted[c] != q[c]; c++)
        memcpy(f->predicted[c], q[c], f->grid->size * sizeof(double));
    fluid_predicted_refresh(f, 1);
    forward(f, 1, 0);
    project(f, 0, 1, 0);
    memset(f->state.p, 0, f->grid->size * sizeof(double));
    memset(f->state.pi, 0, f->grid->size * sizeof(double));
    fluid_state_refresh(f);
}
