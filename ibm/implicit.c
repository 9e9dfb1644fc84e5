/* Forcing with implicit diffusion: solves for the markers' forces by conjugate gradients. */
/* In a large step the force of a marker diffuses over sqrt(nu dt). Increments of the missing velocity, as in
 * ibm_forcing_stage, would then leave a slip that grows with the step. Here the force f of a marker, m/s2, is an
 * unknown of the stage. In a steady flow it leaves the slip of the forcing with feedback (ibm/feedback.h),
 *
 *     V - J u = L f ,   L = T (1 - c J S) ,
 *
 * whatever the step is, with J the reading, S the spreading of A_h dx/cell times a value, and T the slip time. There
 * the slip of a stage is e = T f before its own part w_r e is given, and (1 - w_r J S) e afterwards; over a step that
 * makes c = sum gamma_r w_r. J S is 1/2 for a plane of markers, and less at edges. With H = 1 - b dt nu lap, and u*
 * diffused under the last stage's force, f changes by d:
 *
 *     [L + dt_r J H^-1 S] d = V - J u* - L f ,   u* += dt_r H^-1 S d .
 *
 * The operator is symmetric and positive in the product that weighs each marker by its volume, so the system is solved
 * by conjugate gradients, with one Helmholtz solve an iteration. A steady flow needs no iteration. */
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "ibm/state.h"
#include "physics/rk3.h"

#include <math.h>
#include <string.h>

/* A stage ends when its residual has fallen below PART of its first value, or below OF_SLIP of the slip; or after so
 * many iterations. */
static const double PART = 0.05, OF_SLIP = 2e-3;
enum { ITERATIONS = 40 };

typedef double vector3[3];

static double explicit_stage(const struct ibm *b) { return fluid_limits_explicit_step(b->fluid) / 3; }

static double weight_of(const struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].volume : ibm->edge[h - ibm->inner].volume;
}

static int is_mine(const struct ibm *b, int h) { return h < b->inner || b->edge[h - b->inner].mine; }

/* Sum over all markers, weighed by their volumes. Collective. */
static double dot(const struct ibm *ibm, const vector3 *x, const vector3 *y) {
    double sum = 0;
    for (int h = 0; h < ibm->served; h++)
        if (is_mine(ibm, h)) sum += weight_of(ibm, h) * (x[h][0] * y[h][0] + x[h][1] * y[h][1] + x[h][2] * y[h][2]);
    return par_sum(sum);
}

/* x += a y */
static void add(const struct ibm *ibm, vector3 *x, double a, const vector3 *y) {
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) x[h][c] += a * y[h][c];
}

/* x = a x + y; for a = 0, x is not read (it may be NaN) */
static void turn(const struct ibm *ibm, vector3 *x, double a, const vector3 *y) {
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) x[h][c] = (a == 0 ? 0 : a * x[h][c]) + y[h][c];
}

/* S of a marker's values: by its volume. */
static void write(struct ibm *ibm, double *const u[3], double scale, const vector3 *x) {
    vector3 *strength = ibm->vector[IBM_STRENGTH];
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) strength[h][c] = scale * weight_of(ibm, h) * x[h][c];
    ibm_transfer_write(ibm, u, (const vector3 *)strength);
}

void ibm_implicit_set(struct ibm *ibm, double slip_time) {
    ENSURE(slip_time > 0 && ibm->implicit, "slip time %g", slip_time);
    ibm->slip_time = slip_time;
}

/* The sum of gamma_r w_r, with w_r = gamma_r/gamma_0. */
static double given_within(void) {
    double sum = 0;
    for (int r = 0; r < 3; r++) sum += physics_rk3_gamma[r] * physics_rk3_gamma[r] / physics_rk3_gamma[0];
    return sum;
}

/* read = J S x; leaves S x in the diffusion's field. Collective. */
static void read_written(struct ibm *ibm, const vector3 *x, vector3 *read) {
    double *const *field = fluid_diffusion_field(ibm->fluid);
    fluid_diffusion_clear(ibm->fluid);
    write(ibm, field, 1, x);
    ibm_transfer_read(ibm, field, 0, read);
}

/* Adds the impulse of the force in a stage to the sums of the forcing. */
static void tally(struct ibm *ibm, int r, double dt) {
    const struct fluid_grid *g = ibm->grid;
    const double stage = physics_rk3_gamma[r] * dt;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] * physics_rk3_gamma[r];
    const vector3 *f = (const vector3 *)ibm->vector[IBM_MARKER_FORCE];
    for (int c = 0; c < 3 && r == 0; c++) ibm->total_force[c] = 0;
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) {
            const double share = h < ibm->inner ? 1 : ibm->edge[h - ibm->inner].share[c];
            const double force = weight_of(ibm, h) * f[h][c];
            ibm->received[h][c] = (r == 0 ? 0 : ibm->received[h][c]) + stage * force;
            if (is_mine(ibm, h)) ibm->total_force[c] += scale * share * force;
        }
}

/* RESIDUAL = -L f, the part of the slip law. */
void ibm_implicit_force_again(struct ibm *ibm, int r, double dt) {
    vector3 *residual = ibm->vector[IBM_RESIDUAL];
    const vector3 *f = (const vector3 *)ibm->vector[IBM_MARKER_FORCE];
    const double slip = ibm->slip_time, within = given_within();
    ibm_inside_stage(ibm, r, dt);
    clock_begin(CLOCK_FORCING);
    read_written(ibm, f, residual);
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) residual[h][c] = -slip * (f[h][c] - within * residual[h][c]);
    write(ibm, fluid_predicted(ibm->fluid), physics_rk3_gamma[r] * dt, f);
    clock_end(CLOCK_FORCING);
}

/* Completes the residual once u* is diffused: += V - J u*. Collective. */
static void begin(struct ibm *ibm) {
    vector3 *residual = ibm->vector[IBM_RESIDUAL], *velocity = ibm->vector[IBM_STRENGTH];
    ibm_transfer_read(ibm, fluid_predicted(ibm->fluid), 1, velocity);
    for (int h = 0; h < ibm->served; h++) {
        const double *v = h < ibm->inner ? ibm->stencil[h].v : ibm->edge[h - ibm->inner].v;
        for (int c = 0; c < 3; c++) residual[h][c] += v[c] - velocity[h][c];
    }
}

/* KD = the operator applied to D. Leaves H^-1 S d in the diffusion's field. Collective. */
static void apply(struct ibm *ibm, int r, double dt) {
    const vector3 *d = (const vector3 *)ibm->vector[IBM_D];
    vector3 *kd = ibm->vector[IBM_KD], *diffused = ibm->vector[IBM_STRENGTH];
    const double slip = ibm->slip_time, within = given_within();
    read_written(ibm, d, kd);
    fluid_diffusion_solve(ibm->fluid, r, dt);
    ibm_transfer_read(ibm, fluid_diffusion_field(ibm->fluid), 0, diffused);
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++)
            kd[h][c] = slip * (d[h][c] - within * kd[h][c]) + physics_rk3_gamma[r] * dt * diffused[h][c];
}

void ibm_implicit_force(struct ibm *ibm, int r, double dt) {
    vector3 *residual = ibm->vector[IBM_RESIDUAL], *d = ibm->vector[IBM_D], *f = ibm->vector[IBM_MARKER_FORCE];
    double before = 0, start = 0;
    clock_begin(CLOCK_FORCING);
    begin(ibm);
    for (int k = 0; k < ITERATIONS; k++) {
        const double now = dot(ibm, (const vector3 *)residual, (const vector3 *)residual);
        const double slip = OF_SLIP * OF_SLIP * explicit_stage(ibm) * explicit_stage(ibm) *
                            dot(ibm, (const vector3 *)f, (const vector3 *)f);
        if (k == 0) start = now;
        if (!(now > fmax(PART * PART * start * (k > 0), slip))) break;
        turn(ibm, d, k > 0 ? now / before : 0, (const vector3 *)residual);
        before = now;
        apply(ibm, r, dt);
        const double curvature = dot(ibm, (const vector3 *)d, (const vector3 *)ibm->vector[IBM_KD]);
        if (!(curvature > 0)) break;
        const double a = now / curvature;
        add(ibm, f, a, (const vector3 *)d);
        add(ibm, residual, -a, (const vector3 *)ibm->vector[IBM_KD]);
        fluid_diffusion_add(ibm->fluid, a * physics_rk3_gamma[r] * dt);
    }
    tally(ibm, r, dt);
    clock_end(CLOCK_FORCING);
}
