/* Forcing with implicit diffusion: solves for the markers' forces by conjugate gradients. */
/* In a large step the force of a marker diffuses over sqrt(nu dt). Increments of the missing velocity, as in
 * ibm_forcing_stage, would then leave a slip that grows with the step. Here the force q is an unknown of the stage.
 *
 * With S the spreading of increments, J the reading, and N_s iterations of the multidirect forcing
 *     x = B e:   x = 0;  N_s times  x += (A_h dx/cell) (e - J S x)                          (001: eqs 3.79-3.82)
 * explicit forcing in stages of length s leaves a slip in a steady flow,
 *     V - J u = s (1 - J S B) y ,  q = B y .
 * The same slip is asked for here, with s fixed at the mean stage of the explicit scheme's largest viscous step,
 * whatever the present step is: the wall then has the same position as in the explicit scheme, for which the retraction
 * was calibrated. A long and dense body bounds s further (coupling/interface/leak.c). With H = 1 - b dt nu lap and u*
 * diffused under the last stage's force, y changes by d: [s (1 - J S B) + dt_r J H^-1 S B] d = V - J u* - s (1 - J S B)
 * y ,   u*
 * += dt_r H^-1 S B d . The operator is symmetric and positive in the product <a, B b>, so the system is solved by
 * conjugate gradients, with one Helmholtz solve an iteration. A steady flow needs no iteration. */
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

static double weight_of(const struct ibm *ibm, int h) {
    return h < ibm->inner ? ibm->stencil[h].volume : ibm->edge[h - ibm->inner].volume;
}

static int is_mine(const struct ibm *b, int h) { return h < b->inner || b->edge[h - b->inner].mine; }

/* Sum over all markers. Collective. */
static double dot(const struct ibm *ibm, const vector3 *x, const vector3 *y) {
    double sum = 0;
    for (int h = 0; h < ibm->served; h++)
        if (is_mine(ibm, h)) sum += x[h][0] * y[h][0] + x[h][1] * y[h][1] + x[h][2] * y[h][2];
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

/* x = B e; left = e - J S x. Collective. */
static void multidirect(struct ibm *ibm, const vector3 *e, vector3 *x, vector3 *left) {
    double *const *u = fluid_diffusion_field(ibm->fluid);
    vector3 *increment = ibm->vector[IBM_INCREMENT];
    fluid_diffusion_clear(ibm->fluid);
    memset(x, 0, (size_t)ibm->served * sizeof *x);
    memcpy(left, e, (size_t)ibm->served * sizeof *left);
    for (int s = 0; s < ibm->iterations; s++) {
        for (int h = 0; h < ibm->served; h++)
            for (int c = 0; c < 3; c++) increment[h][c] = weight_of(ibm, h) * left[h][c];
        add(ibm, x, 1, (const vector3 *)increment);
        ibm_whole_write(ibm, u, (const vector3 *)increment);
        ibm_whole_read(ibm, u, 0, left);
        turn(ibm, left, -1, e);
    }
}

static double explicit_stage(const struct ibm *b) { return fluid_limits_explicit_step(b->fluid) / 3; }

static double slip_time(const struct ibm *b) { return fmin(explicit_stage(b), b->most_slip); }

void ibm_implicit_slip(struct ibm *ibm, double most) {
    ENSURE(most > 0 && ibm->implicit, "slip time %g", most);
    ibm->most_slip = most;
}

/* Adds the impulse of q in a stage to the sums of the forcing. */
static void tally(struct ibm *ibm, int r, double dt) {
    const struct fluid_grid *g = ibm->grid;
    const double stage = physics_rk3_gamma[r] * dt;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] * physics_rk3_gamma[r];
    const vector3 *q = (const vector3 *)ibm->vector[IBM_APPLIED_FORCE];
    for (int c = 0; c < 3 && r == 0; c++) ibm->total_force[c] = 0;
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) {
            const double share = h < ibm->inner ? 1 : ibm->edge[h - ibm->inner].share[c];
            ibm->received[h][c] = (r == 0 ? 0 : ibm->received[h][c]) + stage * q[h][c];
            if (is_mine(ibm, h)) ibm->total_force[c] += scale * share * q[h][c];
        }
}

/* q = B y; RESIDUAL = -s (1 - J S B) y, the part of the slip law. */
void ibm_implicit_force_again(struct ibm *ibm, int r, double dt) {
    vector3 *residual = ibm->vector[IBM_RESIDUAL], *q = ibm->vector[IBM_APPLIED_FORCE];
    ibm_inside_stage(ibm, r, dt);
    clock_begin(CLOCK_FORCING);
    multidirect(ibm, (const vector3 *)ibm->vector[IBM_MARKER_FORCE], q, residual);
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) residual[h][c] *= -slip_time(ibm);
    memcpy(ibm->vector[IBM_TARGET], q, (size_t)ibm->served * sizeof *q);
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) ibm->vector[IBM_TARGET][h][c] *= physics_rk3_gamma[r] * dt;
    ibm_whole_write(ibm, fluid_predicted(ibm->fluid), (const vector3 *)ibm->vector[IBM_TARGET]);
    clock_end(CLOCK_FORCING);
}

/* Completes the residual once u* is diffused: += V - J u*. Collective. */
static void begin(struct ibm *ibm) {
    vector3 *residual = ibm->vector[IBM_RESIDUAL], *velocity = ibm->vector[IBM_TARGET];
    ibm_whole_read(ibm, fluid_predicted(ibm->fluid), 1, velocity);
    for (int h = 0; h < ibm->served; h++) {
        const double *v = h < ibm->inner ? ibm->stencil[h].v : ibm->edge[h - ibm->inner].v;
        for (int c = 0; c < 3; c++) residual[h][c] += v[c] - velocity[h][c];
    }
}

/* KD = the operator applied to D, from D and BD. Leaves dt_r H^-1 S B d in the diffusion's field. Collective. */
static void apply(struct ibm *ibm, int r, double dt) {
    double *const *u = fluid_diffusion_field(ibm->fluid);
    vector3 *kd = ibm->vector[IBM_KD], *read = ibm->vector[IBM_TARGET];
    const double s = slip_time(ibm), stage = physics_rk3_gamma[r] * dt;
    fluid_diffusion_clear(ibm->fluid);
    ibm_whole_write(ibm, u, (const vector3 *)ibm->vector[IBM_BD]);
    ibm_whole_read(ibm, u, 0, read);
    for (int h = 0; h < ibm->served; h++)
        for (int c = 0; c < 3; c++) kd[h][c] = s * (ibm->vector[IBM_D][h][c] - read[h][c]);
    fluid_diffusion_solve(ibm->fluid, r, dt);
    ibm_whole_read(ibm, u, 0, read);
    add(ibm, kd, stage, (const vector3 *)read);
}

void ibm_implicit_force(struct ibm *ibm, int r, double dt) {
    vector3 **v = ibm->vector, *residual = v[IBM_RESIDUAL], *z = v[IBM_Z], *d = v[IBM_D], *bd = v[IBM_BD];
    const double stage = physics_rk3_gamma[r] * dt;
    double before = 0, start = 0;
    clock_begin(CLOCK_FORCING);
    begin(ibm);
    for (int k = 0; k < ITERATIONS; k++) {
        multidirect(ibm, (const vector3 *)residual, z, v[IBM_TARGET]);
        const double now = dot(ibm, (const vector3 *)residual, (const vector3 *)z);
        const double slip = explicit_stage(ibm) * explicit_stage(ibm) *
                            dot(ibm, (const vector3 *)v[IBM_MARKER_FORCE], (const vector3 *)v[IBM_APPLIED_FORCE]);
        if (k == 0) start = now;
        if (!(now > fmax(PART * PART * start * (k > 0), OF_SLIP * OF_SLIP * slip))) break;
        turn(ibm, d, k > 0 ? now / before : 0, (const vector3 *)residual);
        turn(ibm, bd, k > 0 ? now / before : 0, (const vector3 *)z);
        before = now;
        apply(ibm, r, dt);
        const double curvature = dot(ibm, (const vector3 *)bd, (const vector3 *)v[IBM_KD]);
        if (!(curvature > 0)) break;
        const double a = now / curvature;
        add(ibm, v[IBM_MARKER_FORCE], a, (const vector3 *)d);
        add(ibm, v[IBM_APPLIED_FORCE], a, (const vector3 *)bd);
        add(ibm, residual, -a, (const vector3 *)v[IBM_KD]);
        fluid_diffusion_add(ibm->fluid, a * stage);
    }
    tally(ibm, r, dt);
    clock_end(CLOCK_FORCING);
}
