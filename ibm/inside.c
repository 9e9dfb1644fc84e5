/* Holds the fluid inside a body that has no ends. */
/* A gradient or a body force acts on all of the domain. Inside a closed body the pressure of its ends balances it. A
 * body that goes on through the periodic sides along the force has no ends, and the fluid inside it would flow as
 * through a pipe. What the ends would do is done here: a uniform gradient h inside, m/s2, leaves no net flow. With g the
 * length of a stage, and theta the solid part of the two cells that a face is between,
 *
 *     q = sum(theta u)/sum(theta^2) ,   h <- h + q/dt ,   before the step
 *     u* -= g h theta                                     in each stage, and q theta in the first.
 *
 * In a steady flow q = 0, whatever the step is. What is taken counts as the forcing's. */
#include "base/clock.h"
#include "base/par.h"
#include "ibm/state.h"
#include "physics/rk3.h"

#include <string.h>

void ibm_inside_hold(struct ibm *ibm, const int along[3], const double *fraction, double gradient[3]) {
    memcpy(ibm->inside.along, along, sizeof ibm->inside.along);
    ibm->inside.fraction = fraction;
    ibm->inside.gradient = gradient;
}

static ptrdiff_t next_along(const struct fluid_grid *g, int c) { return c == 0 ? 1 : c == 1 ? g->row : g->plane; }

/* sum[0]: of theta u, sum[1]: of theta^2, sum[2]: of theta; over this rank's faces along c. */
static void sums_of(const struct ibm *ibm, int c, const double *u, double sum[3]) {
    const struct fluid_grid *g = ibm->grid;
    const ptrdiff_t next = next_along(g, c);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t at = fluid_grid_at(g, 0, j, k);
            const double *f = ibm->inside.fraction + at, *q = u + at;
            for (int i = 0; i < g->m[0]; i++) {
                const double theta = 0.5 * (f[i] + f[i + next]);
                sum[0] += theta * q[i], sum[1] += theta * theta, sum[2] += theta;
            }
        }
}

static void take(const struct ibm *ibm, int c, double *u, double a) {
    const struct fluid_grid *g = ibm->grid;
    const ptrdiff_t next = next_along(g, c);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t at = fluid_grid_at(g, 0, j, k);
            const double *f = ibm->inside.fraction + at;
            double *q = u + at;
            for (int i = 0; i < g->m[0]; i++) q[i] -= 0.5 * a * (f[i] + f[i + next]);
        }
}

void ibm_inside_begin(struct ibm *ibm, double dt) {
    struct ibm_inside *inside = &ibm->inside;
    const struct fluid_state *state = fluid_state_of(ibm->fluid);
    const double *const u[3] = {state->u, state->v, state->w};
    if (!inside->fraction) return;
    clock_begin(CLOCK_FORCING);
    for (int c = 0; c < 3; c++) {
        double sum[3] = {0};
        if (!inside->along[c]) continue;
        sums_of(ibm, c, u[c], sum);
        par_sum_array(sum, 3);
        inside->flow[c] = sum[1] > 0 ? sum[0] / sum[1] : 0;
        inside->faces[c] = sum[2];
        inside->gradient[c] += inside->flow[c] / dt;
    }
    clock_end(CLOCK_FORCING);
}

void ibm_inside_stage(struct ibm *ibm, int r, double dt) {
    struct ibm_inside *inside = &ibm->inside;
    if (!inside->fraction) return;
    clock_begin(CLOCK_FORCING);
    const struct fluid_grid *g = ibm->grid;
    const double mass = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2];
    for (int c = 0; c < 3; c++) {
        if (!inside->along[c]) continue;
        const double a = physics_rk3_gamma[r] * dt * inside->gradient[c] + (r == 0 ? inside->flow[c] : 0);
        take(ibm, c, fluid_predicted(ibm->fluid)[c], a);
        inside->taken[c] = (r == 0 ? 0 : inside->taken[c]) - mass * a * inside->faces[c] / dt;
    }
    clock_end(CLOCK_FORCING);
}
