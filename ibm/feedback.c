/* Forcing whose force is kept from stage to stage and follows the slip: direct forcing with integral feedback. */
/* Direct forcing alone gives its force again in each stage, so a steady force needs a slip that is proportional to the
 * step. Here each marker keeps its force f, m/s2, and an integrator changes it by the slip (Goldstein et al. 1993, with
 * the direct forcing in the place of their damping). For stage r of length g = gamma_r dt, with J the reading, S the
 * spreading of A_h dx/cell times a value, and V the wall's velocity,
 *
 *     u* += S (g f) ,   U = J u* ,   e = V - U ,   u* += S (w e) ,   w = g/max(s, g_1) ,
 * and after the step
 *     f <- (f + sum_r (g_r/k) e_r) / (1 + c dt/k) ,   k = dt^2 ,   1/c = 1/s - sum_r w_r/dt ,
 *
 * with g_1 the longest stage: the first one of RK3, the whole step of AB2.
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
#include "base/threads.h"
#include "fluid/scheme.h"
#include "ibm/state.h"

#include <math.h>
#include <string.h>

/* The time of the integrator, sqrt(k), over the step. */
static const double INTEGRATOR = 1.0;

void ibm_feedback_set(struct ibm *ibm, double slip_time) {
    ENSURE(slip_time > 0 && ibm->served == 0, "slip time %g", slip_time);
    ibm->slip_time = slip_time;
}

static double longest(const struct ibm *ibm, double dt) { return fluid_scheme_gamma_max(ibm->fluid) * dt; }
static double length(const struct ibm *ibm, int r, double dt) { return fluid_scheme_gamma(ibm->fluid, r) * dt; }
static int is_last(const struct ibm *ibm, int r) { return r == fluid_scheme_stages(ibm->fluid) - 1; }

static double weight(const struct ibm *ibm, int r, double dt) {
    return length(ibm, r, dt) / fmax(ibm->slip_time, longest(ibm, dt));
}

double ibm_feedback_weight(const struct ibm *ibm, int r, double dt) { return weight(ibm, r, dt); }

static double volume_of(const struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].volume : ibm->edge[h - ibm->inner].volume;
}

static double *velocity_of(struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].v : ibm->edge[h - ibm->inner].v;
}

/* What the threads share in a stage. */
struct stage {
    struct ibm *ibm;
    double *const *u;
    int r, is_last;
    double g;                   /* gamma_r dt, s */
    double w, gain, decay;      /* 1, 1/s, 1 */
    const double (*arrived)[3]; /* slips in the order of arrival, m/s; NULL: those of the markers' velocities */
};

/* The increments of the kept force of the markers first .. last-1. */
static void begin_markers(const struct stage *s, int first, int last) {
    struct ibm *ibm = s->ibm;
    for (int h = first; h < last; h++) {
        const double scale = s->g * volume_of(ibm, h);
        for (int c = 0; c < 3; c++) ibm->increment[h][c] = scale * ibm->vector[IBM_MARKER_FORCE][h][c];
    }
}

/* On one thread a slab is read as soon as it and its two neighbours are written. */
static void begin_all(const struct stage *s) {
    struct ibm *ibm = s->ibm;
    begin_markers(s, 0, ibm->served);
    for (int pair = 0; pair < ibm->slabs + 2; pair += 2) {
        for (int k = pair; k >= pair - 1; k--) ibm_slabs_write(ibm, s->u, k);
        for (int k = pair - 2; k < pair; k++) ibm_slabs_read(ibm, s->u, k, ibm->velocity);
    }
}

static void begin_part(int thread, void *data) {
    const struct stage *s = data;
    struct ibm *ibm = s->ibm;
    int from, to;
    threads_share(ibm->served, 1, thread, &from, &to);
    begin_markers(s, from, to);
    ibm_slabs_share(ibm, thread, &from, &to);
    ibm_slabs_write_part(ibm, s->u, from, to);
    threads_wait();
    for (int k = from; k < to; k++) ibm_slabs_read(ibm, s->u, k, ibm->velocity);
}

/* With implicit diffusion the kept force diffuses with the velocity, and then U is read. */
static void begin_diffused(const struct stage *s, double dt) {
    struct ibm *ibm = s->ibm;
    double(*strength)[3] = ibm->vector[IBM_STRENGTH];
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) strength[h][c] = s->g * volume_of(ibm, h) * ibm->vector[IBM_MARKER_FORCE][h][c];
    ibm_transfer_write(ibm, s->u, (const double(*)[3])strength);
    fluid_diffusion_stage(ibm->fluid, s->r, dt);
    fluid_box_force_close(ibm->fluid, s->r);
    ibm_transfer_read(ibm, s->u, 1, ibm->velocity);
}

void ibm_feedback_begin(struct ibm *ibm, int r, double dt) {
    clock_begin(CLOCK_FORCING);
    struct stage s = {.ibm = ibm, .u = fluid_predicted(ibm->fluid), .r = r, .g = length(ibm, r, dt)};
    if (ibm->implicit)
        begin_diffused(&s, dt);
    else if (threads_count() == 1)
        begin_all(&s);
    else
        threads_run(begin_part, &s);
    if (!ibm->implicit) ibm_slabs_finish(ibm, s.u, 1, ibm->velocity);
    clock_end(CLOCK_FORCING);
}

/* Gives the markers first .. last-1 their increments w e, and changes f by e; the impulse is counted. e: the mean slip
 * V - U of the stage, m/s; it takes the place of U. */
static void end_markers(const struct stage *s, int first, int last, struct ibm_tally *t) {
    struct ibm *ibm = s->ibm;
    for (int h = first; h < last; h++) {
        const double volume = volume_of(ibm, h);
        const struct ibm_edge *edge = h < ibm->inner ? NULL : &ibm->edge[h - ibm->inner];
        const double *arrived = s->arrived ? s->arrived[ibm->arrival[h]] : NULL;
        double *f = ibm->vector[IBM_MARKER_FORCE][h], *change = ibm->change[h], *v = velocity_of(ibm, h);
        for (int c = 0; c < 3; c++) {
            const double e = arrived ? arrived[c] : v[c] - ibm->velocity[h][c];
            const double direct = volume * s->w * e, all = direct + volume * s->g * f[c];
            if (arrived) v[c] = ibm->velocity[h][c] + e;
            ibm->velocity[h][c] = e;
            ibm->increment[h][c] = direct;
            ibm->received[h][c] = (s->r == 0 ? 0 : ibm->received[h][c]) + all;
            if (!edge || edge->mine) t->impulse[c] += (edge ? edge->share[c] : 1) * all;
            change[c] = (s->r == 0 ? 0 : change[c]) + s->gain * e;
            if (s->is_last) f[c] = s->decay * (f[c] + change[c]);
        }
    }
}

static void end_part(int thread, void *data) {
    const struct stage *s = data;
    struct ibm *ibm = s->ibm;
    int from, to;
    ibm_slabs_share(ibm, thread, &from, &to);
    for (int k = from; k < to; k++) {
        ibm->tally[k] = (struct ibm_tally){.squares = 0};
        end_markers(s, ibm_slab_first(ibm, IBM_INNER, k), ibm_slab_first(ibm, IBM_INNER, k + 1), &ibm->tally[k]);
        end_markers(s, ibm->inner + ibm_slab_first(ibm, IBM_NEAR, k), ibm->inner + ibm_slab_first(ibm, IBM_NEAR, k + 1),
                    &ibm->tally[k]);
    }
    if (thread == 0) {
        ibm->tally[ibm->slabs] = (struct ibm_tally){.squares = 0};
        end_markers(s, ibm->inner + ibm->near_edges, ibm->served, &ibm->tally[ibm->slabs]);
    }
    ibm_slabs_write_part(ibm, s->u, from, to);
}

static void give(struct ibm *ibm, int r, double dt, const double (*arrived)[3]) {
    const struct fluid_grid *g = ibm->grid;
    struct stage s = {
        .ibm = ibm, .u = fluid_predicted(ibm->fluid), .r = r, .is_last = is_last(ibm, r), .arrived = arrived};
    const double k = INTEGRATOR * dt * INTEGRATOR * dt;
    double sum = 0;
    for (int q = 0; q < fluid_scheme_stages(ibm->fluid); q++) sum += weight(ibm, q, dt);
    const double inverse_c = fmax(0, 1 / ibm->slip_time - sum / dt);
    s.g = length(ibm, r, dt);
    s.w = weight(ibm, r, dt);
    s.gain = s.g / k;
    s.decay = inverse_c / (inverse_c + dt / k);
    threads_run(end_part, &s);
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    for (int c = 0; c < 3; c++) {
        double all = 0;
        for (int slab = 0; slab <= ibm->slabs; slab++) all += ibm->tally[slab].impulse[c];
        ibm->total_force[c] = (r == 0 ? 0 : ibm->total_force[c]) + scale * all;
    }
}

void ibm_feedback_end(struct ibm *ibm, int r, double dt) {
    clock_begin(CLOCK_FORCING);
    give(ibm, r, dt, NULL);
    clock_end(CLOCK_FORCING);
}

/* Edges are read with the weights that spread their force, as only these do work on the fluid. */
void ibm_feedback_read_again(struct ibm *ibm) {
    const struct fluid_state *state = fluid_state_of(ibm->fluid);
    double *const u[3] = {state->u, state->v, state->w};
    ibm_sweep_read(ibm, u, 0, ibm->inner, ibm->velocity);
    ibm_edge_sum_spread(ibm, u);
    ibm_share_sums(ibm);
    ibm_edge_velocity(ibm, 0, ibm->velocity + ibm->inner);
}

/* In a steady flow the work of the other terms and this one add up to zero for U after the step, not for the U of the
 * stages. */
double ibm_feedback_slip_loss(struct ibm *ibm, double dt) {
    const struct fluid_grid *g = ibm->grid;
    double sum = 0;
    ibm_feedback_read_again(ibm);
    for (int h = 0; h < ibm->served; h++) {
        const double *v = velocity_of(ibm, h);
        if (h >= ibm->inner && !ibm->edge[h - ibm->inner].mine) continue;
        for (int c = 0; c < 3; c++) sum += ibm->received[h][c] * (v[c] - ibm->velocity[h][c]);
    }
    return par_sum(sum) * fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
}

static void out_part(int thread, void *data) {
    struct ibm *ibm = data;
    double(*served)[3] = (double(*)[3])ibm->by_marker;
    int from, to;
    threads_share(ibm->served, 1, thread, &from, &to);
    for (int h = from; h < to; h++) memcpy(served[ibm->arrival[h]], ibm->velocity[h], sizeof *served);
}

void ibm_feedback_velocity(struct ibm *ibm, double (*velocity)[3]) {
    clock_begin(CLOCK_FORCING);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    threads_run(out_part, ibm);
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3 && !ibm_feedback_is_in_domain(ibm, i); c++) velocity[i][c] = 0;
    par_exchange_backward(ibm->route.plan, ibm->by_marker, velocity, sizeof *velocity);
    clock_end(CLOCK_FORCING);
}

const double (*ibm_feedback_force(const struct ibm *ibm))[3] { return (const double(*)[3])ibm->marker_force; }

int ibm_feedback_is_in_domain(const struct ibm *ibm, int i) { return ibm->route.key[i] >= 0; }

void ibm_feedback_apply_slip(struct ibm *ibm, int r, double dt, const double (*slip)[3]) {
    clock_begin(CLOCK_FORCING);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    double(*served)[3] = (double(*)[3])ibm->by_marker;
    par_exchange_forward(ibm->route.plan, slip, served, sizeof *served);
    give(ibm, r, dt, (const double(*)[3])served);
    clock_end(CLOCK_FORCING);
}
