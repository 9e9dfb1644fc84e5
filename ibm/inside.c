/* Leaves the fluid inside a body undriven. */
/* A gradient or a body force acts on all of the domain. Inside a closed body the pressure of its ends balances it: a
 * long body has a jump of pressure at its walls, which falls along it from +dp/2 to -dp/2. The forcing spreads the jump
 * over the kernel, so the fluid beside the wall is driven less than it should, and a little of it passes through
 * (coupling/interface/leak.c). A body that goes on through the periodic sides has no ends, and the fluid inside it
 * would flow as through a pipe.
 *
 * So each stage of length g takes the driving and the body force b, m/s2, from the part of a face that is solid:
 *
 *     u* -= g b theta ,
 *
 * with theta the mean solid part of the two cells that the face is between. What is taken counts as the forcing's,
 * since it is the part of the driving that the solid holds.
 *
 * Between layers of fluid the solid part is that of the cell's volume: the pressure then makes up for the rest. In an
 * endless body nothing does, and the curvature of the flow's profile under the kernel, b v/(2 nu) with v the kernel's
 * second moment, would set the wall outward by 0.25/h cells in a slit of h cells. So there the solid's volume is spread
 * by the forcing's kernel, as every force that the solid exerts on the fluid is: this leaves less than 0.05/h. */
#include "base/clock.h"
#include "fluid/scheme.h"
#include "ibm/state.h"

#include <string.h>

void ibm_inside_undriven(struct ibm *ibm, const double *const part[3]) {
    memcpy(ibm->inside.part, part, sizeof ibm->inside.part);
}

void ibm_inside_begin(struct ibm *ibm) { memset(ibm->inside.taken, 0, sizeof ibm->inside.taken); }

void ibm_inside_count(struct ibm *ibm, double dt, const double sum[3]) {
    const struct fluid_grid *g = ibm->grid;
    const double mass = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2];
    for (int c = 0; c < 3; c++) ibm->inside.taken[c] += mass * sum[c] / dt;
}

void ibm_inside_share(const struct ibm *ibm, double force[3]) { memcpy(force, ibm->inside.taken, 3 * sizeof *force); }

/* u* -= a theta along c. Returns this rank's sum of theta. */
static double take(const struct ibm *ibm, int c, double *u, double a) {
    const struct fluid_grid *g = ibm->grid;
    const ptrdiff_t next = c == 0 ? 1 : c == 1 ? g->row : g->plane;
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t at = fluid_grid_at(g, 0, j, k);
            const double *f = ibm->inside.part[c] + at;
            double *q = u + at;
            for (int i = 0; i < g->m[0]; i++) {
                const double theta = 0.5 * (f[i] + f[i + next]);
                q[i] -= a * theta;
                sum += theta;
            }
        }
    return sum;
}

void ibm_inside_stage(struct ibm *ibm, int r, double dt) {
    struct ibm_inside *inside = &ibm->inside;
    if (!inside->part[0] && !inside->part[1] && !inside->part[2]) return;
    clock_begin(CLOCK_FORCING);
    const struct fluid_grid *g = ibm->grid;
    const double mass = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2];
    for (int c = 0; c < 3; c++) {
        if (!inside->part[c]) continue;
        const double of_stage = fluid_scheme_gamma(ibm->fluid, r) * fluid_source(ibm->fluid, c);
        const double sum = take(ibm, c, fluid_predicted(ibm->fluid)[c], of_stage * dt);
        inside->taken[c] -= mass * of_stage * sum;
    }
    clock_end(CLOCK_FORCING);
}
