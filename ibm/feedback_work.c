/* Work of the forcing with feedback on the fluid in a step, as the scheme has it. */
/* A stage takes the fluid from one solenoidal velocity u_r to the next, u_(r+1). So its kinetic energy changes by the
 * products of all impulses with (u_r + u_(r+1))/2, in which pressures have no part. The forcing's share is the sum over
 * the markers of I_r (U_r + U_(r+1))/2, with the impulse I_r of the stage, and the velocities U read with the weights
 * by which the impulse was spread. */
#include "ibm/feedback_work.h"
#include "base/memory.h"
#include "ibm/state.h"

#include <string.h>

static void reserve(struct ibm_work *w, int n) {
    if (n <= w->capacity && w->u) return;
    w->capacity = n + n / 4 + 64;
    memory_free(w->u);
    memory_free(w->received);
    w->u = memory_new(MEMORY_IBM, (size_t)w->capacity, sizeof *w->u);
    w->received = memory_new(MEMORY_IBM, (size_t)w->capacity, sizeof *w->received);
}

void ibm_feedback_work_begin(struct ibm *ibm) {
    struct ibm_work *w = &ibm->work;
    const size_t bytes = (size_t)ibm->served * sizeof *w->u;
    reserve(w, ibm->served);
    w->sum = 0;
    ibm_feedback_read_again(ibm);
    memcpy(w->u, ibm->velocity, bytes);
    memset(w->received, 0, bytes);
}

void ibm_feedback_work_add(struct ibm *ibm) {
    struct ibm_work *w = &ibm->work;
    const struct fluid_grid *g = ibm->grid;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2];
    ibm_feedback_read_again(ibm);
    for (int h = 0; h < ibm->served; h++) {
        const int counts = h < ibm->inner || ibm->edge[h - ibm->inner].mine;
        for (int c = 0; c < 3; c++) {
            const double now = ibm->velocity[h][c], all = ibm->received[h][c];
            if (counts) w->sum += scale * (all - w->received[h][c]) * 0.5 * (w->u[h][c] + now);
            w->u[h][c] = now;
            w->received[h][c] = all;
        }
    }
}

double ibm_feedback_work_sum(const struct ibm *ibm) { return ibm->work.sum; }
