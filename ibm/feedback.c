/* Forcing whose force is kept from stage to stage and follows the slip: direct forcing with integral feedback. */
/* Direct forcing alone gives its force anew in each stage, so a steady force needs a slip that is proportional to the
 * step. Here each marker keeps its force f, m/s2, and an integrator changes it by the slip (Goldstein et al. 1993, with
 * the direct forcing in the place of their damping). For stage r of length g = gamma_r dt, with J the reading, S the
 * spreading of A_h dx/cell times a value, and V the wall's velocity,
 *
 *     u* += S (g f) ,   U = J u* ,   e = V - U ,   u* += S (w e) ,   w = g/max(s, g_1) ,
 * and after the step
 *     f <- (f + sum_r (g_r/k) e_r) / (1 + c dt/k) ,   k = dt^2 ,   1/c = 1/s - sum_r w_r/dt .
 *
 * In a steady flow e = c f, and each stage has its share gamma_r of the step's impulse F dt = f dt + sum_r w_r e. So
 * the slip is e = s F: s is a time that belongs to the scene, and the wall does not move with the step as long as
 * s < g_1. A force that the markers cannot see (J S f = 0), as one that changes its sign from marker to marker,
 * fades in the time k/c; without s it would stay. For w J S <= 1 the sum of the fluid's energy, of k |f|^2/2 and of the
 * predictor pressure's part does not grow. */
#include "ibm/feedback.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "ibm/state.h"
#include "physics/rk3.h"

#include <math.h>
#include <string.h>

/* The time of the integrator, sqrt(k), over the step. */
static const double INTEGRATOR = 1.0;

void ibm_feedback_set(struct ibm *ibm, double slip_time) {
    ENSURE(slip_time > 0 && ibm->served == 0 && !ibm->implicit, "slip time %g", slip_time);
    ibm->slip_time = slip_time;
}

static double weight(const struct ibm *ibm, int r, double dt) {
    return physics_rk3_gamma[r] * dt / fmax(ibm->slip_time, physics_rk3_gamma[0] * dt);
}

double ibm_feedback_weight(const struct ibm *ibm, int r, double dt) { return weight(ibm, r, dt); }

static double volume_of(const struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].volume : ibm->edge[h - ibm->inner].volume;
}

static double *velocity_of(struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].v : ibm->edge[h - ibm->inner].v;
}

static void write_slab(const struct ibm *ibm, double *const u[3], int slab) {
    ibm_sweep_scatter(ibm, u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1));
    ibm_edge_scatter(ibm, u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab),
                     ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
    ibm_edge_scatter(ibm, u, ibm_slab_first(ibm, IBM_FAR_PIECES, slab), ibm_slab_first(ibm, IBM_FAR_PIECES, slab + 1));
}

static void read_slab(struct ibm *ibm, double *const u[3], int slab) {
    ibm_sweep_read(ibm, u, ibm_slab_first(ibm, IBM_INNER, slab), ibm_slab_first(ibm, IBM_INNER, slab + 1),
                   ibm->velocity);
    ibm_edge_sum(ibm, u, ibm_slab_first(ibm, IBM_NEAR_PIECES, slab), ibm_slab_first(ibm, IBM_NEAR_PIECES, slab + 1));
    ibm_edge_sum(ibm, u, ibm_slab_first(ibm, IBM_FAR_PIECES, slab), ibm_slab_first(ibm, IBM_FAR_PIECES, slab + 1));
}

/* A slab can be read once it and its two neighbours are written. */
void ibm_feedback_begin(struct ibm *ibm, int r, double dt) {
    clock_begin(CLOCK_FORCING);
    double *const *u = fluid_predicted(ibm->fluid);
    const double g = physics_rk3_gamma[r] * dt;
    for (int h = 0; h < ibm->served; h++) {
        const double scale = g * volume_of(ibm, h);
        for (int c = 0; c < 3; c++) ibm->increment[h][c] = scale * ibm->vector[IBM_DEMAND][h][c];
    }
    for (int s = 0; s <= ibm->slabs; s++) {
        if (s < ibm->slabs) write_slab(ibm, u, s);
        if (s > 0) read_slab(ibm, u, s - 1);
    }
    ibm_share_sums(ibm);
    ibm_edge_velocity(ibm, 1, ibm->velocity + ibm->inner);
    clock_end(CLOCK_FORCING);
}

struct law {
    double g, w, gain, inverse_c; /* s, 1, 1/s, 1/s */
};

static struct law law_of(const struct ibm *ibm, int r, double dt) {
    double sum = 0;
    for (int q = 0; q < 3; q++) sum += weight(ibm, q, dt);
    const double g = physics_rk3_gamma[r] * dt;
    return (struct law){g, weight(ibm, r, dt), g / (INTEGRATOR * dt * INTEGRATOR * dt),
                        fmax(0, 1 / ibm->slip_time - sum / dt)};
}

/* Gives the fluid w e and changes f by e; the impulse is counted. e: the mean slip V - U of the stage, m/s. */
static void give(struct ibm *ibm, int r, double dt, const double (*e)[3]) {
    const struct fluid_grid *g = ibm->grid;
    const struct law law = law_of(ibm, r, dt);
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    const double keep = law.inverse_c / (law.inverse_c + 1 / (INTEGRATOR * INTEGRATOR * dt));
    for (int c = 0; c < 3 && r == 0; c++) ibm->given[c] = 0;
    for (int h = 0; h < ibm->served; h++) {
        const double volume = volume_of(ibm, h);
        const struct ibm_edge *edge = h < ibm->inner ? NULL : &ibm->edge[h - ibm->inner];
        double *f = ibm->vector[IBM_DEMAND][h], *change = ibm->change[h];
        for (int c = 0; c < 3; c++) {
            const double direct = volume * law.w * e[h][c], all = direct + volume * law.g * f[c];
            ibm->increment[h][c] = direct;
            ibm->received[h][c] = (r == 0 ? 0 : ibm->received[h][c]) + all;
            if (!edge || edge->mine) ibm->given[c] += scale * (edge ? edge->share[c] : 1) * all;
            change[c] = (r == 0 ? 0 : change[c]) + law.gain * e[h][c];
            if (r == 2) f[c] = keep * (f[c] + change[c]);
        }
    }
    double *const *u = fluid_predicted(ibm->fluid);
    for (int s = 0; s < ibm->slabs; s++) write_slab(ibm, u, s);
}

void ibm_feedback_end(struct ibm *ibm, int r, double dt) {
    clock_begin(CLOCK_FORCING);
    for (int h = 0; h < ibm->served; h++) {
        const double *v = velocity_of(ibm, h);
        for (int c = 0; c < 3; c++) ibm->velocity[h][c] = v[c] - ibm->velocity[h][c];
    }
    give(ibm, r, dt, (const double(*)[3])ibm->velocity);
    clock_end(CLOCK_FORCING);
}

/* In a steady flow the work of the other terms and this one add up to zero for U after the step, not for the U of the
 * stages. Edges are read with the weights that spread their force, as only these do work on the fluid. */
double ibm_feedback_lost(struct ibm *ibm, double dt) {
    const struct fluid_grid *g = ibm->grid;
    const struct fluid_state *state = fluid_state_of(ibm->fluid);
    double *const u[3] = {state->u, state->v, state->w};
    double sum = 0;
    ibm_sweep_read(ibm, u, 0, ibm->inner, ibm->velocity);
    ibm_edge_sum_spread(ibm, u);
    ibm_share_sums(ibm);
    ibm_edge_velocity(ibm, 0, ibm->velocity + ibm->inner);
    for (int h = 0; h < ibm->served; h++) {
        const double *v = velocity_of(ibm, h);
        if (h >= ibm->inner && !ibm->edge[h - ibm->inner].mine) continue;
        for (int c = 0; c < 3; c++) sum += ibm->received[h][c] * (v[c] - ibm->velocity[h][c]);
    }
    return par_sum(sum) * fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
}

enum { SENT = IBM_FEEDBACK_SENT };

void ibm_feedback_out(struct ibm *ibm, double (*out)[SENT]) {
    clock_begin(CLOCK_FORCING);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, SENT * (size_t)ibm->served + 1);
    double(*served)[SENT] = (double(*)[SENT])ibm->by_marker;
    for (int h = 0; h < ibm->served; h++) {
        double *to = served[ibm->arrival[h]];
        memcpy(to, ibm->velocity[h], 3 * sizeof *to);
        memcpy(to + 3, ibm->vector[IBM_DEMAND][h], 3 * sizeof *to);
        to[6] = 1;
    }
    memset(out, 0, (size_t)ibm->route.n * sizeof *out);
    par_exchange_backward(ibm->route.plan, served, out, sizeof *served);
    clock_end(CLOCK_FORCING);
}

void ibm_feedback_in(struct ibm *ibm, int r, double dt, const double (*slip)[3]) {
    clock_begin(CLOCK_FORCING);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    double(*served)[3] = (double(*)[3])ibm->by_marker;
    par_exchange_forward(ibm->route.plan, slip, served, sizeof *served);
    for (int h = 0; h < ibm->served; h++) {
        double *v = velocity_of(ibm, h);
        for (int c = 0; c < 3; c++) {
            v[c] = ibm->velocity[h][c] + served[ibm->arrival[h]][c];
            ibm->velocity[h][c] = served[ibm->arrival[h]][c];
        }
    }
    give(ibm, r, dt, (const double(*)[3])ibm->velocity);
    clock_end(CLOCK_FORCING);
}
