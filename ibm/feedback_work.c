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
    MEMORY_FREE(w->u, w->received);
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

/* Sum of (I_r)(U_r + U_(r+1)) of the markers first .. last-1, m2/s2; the present values are stored. */
static double add_up(struct ibm *ibm, int first, int last) {
    const double *restrict now = ibm->velocity[0], *restrict all = ibm->received[0];
    double *restrict u = ibm->work.u[0], *restrict received = ibm->work.received[0], sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 3 * first; i < 3 * last; i++) {
        sum += (all[i] - received[i]) * (u[i] + now[i]);
        u[i] = now[i];
        received[i] = all[i];
    }
    return sum;
}

void ibm_feedback_work_add(struct ibm *ibm) {
    struct ibm_work *w = &ibm->work;
    const struct fluid_grid *g = ibm->grid;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2];
    ibm_feedback_read_again(ibm);
    double sum = add_up(ibm, 0, ibm->inner);
    for (int h = ibm->inner; h < ibm->served; h++) {
        const double of_edge = add_up(ibm, h, h + 1);
        if (ibm->edge[h - ibm->inner].mine) sum += of_edge;
    }
    w->sum += 0.5 * scale * sum;
}

double ibm_feedback_work_sum(const struct ibm *ibm) { return ibm->work.sum; }
