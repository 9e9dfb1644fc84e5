/* Interpolation to all markers and spreading from them, inner ones and edges, in one call. */
#include "base/clock.h"
#include "base/threads.h"
#include "ibm/state.h"

#include <string.h>

/* What the threads share: velocities that are read, or strengths that are written. */
struct transfer {
    struct ibm *ibm;
    double *const *u;
    double (*velocity)[3];
    const double (*strength)[3];
};

static void read_part(int thread, void *data) {
    const struct transfer *w = data;
    int from, to;
    ibm_slabs_share(w->ibm, thread, &from, &to);
    for (int s = from; s < to; s++) ibm_slabs_read(w->ibm, w->u, s, w->velocity);
}

void ibm_transfer_read(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]) {
    struct transfer w = {.ibm = ibm, .u = u, .velocity = velocity};
    threads_run(read_part, &w);
    ibm_slabs_finish(ibm, u, with_sides, velocity);
}

static void write_part(int thread, void *data) {
    const struct transfer *w = data;
    int from, to;
    threads_share(w->ibm->served, 1, thread, &from, &to);
    memcpy(w->ibm->increment + from, w->strength + from, (size_t)(to - from) * sizeof *w->strength);
    ibm_slabs_share(w->ibm, thread, &from, &to);
    ibm_slabs_write_part(w->ibm, w->u, from, to);
}

void ibm_transfer_write(struct ibm *ibm, double *const u[3], const double (*strength)[3]) {
    struct transfer w = {.ibm = ibm, .u = u, .strength = strength};
    threads_run(write_part, &w);
}

void ibm_transfer_sample(struct ibm *ibm, double *const u[3], double (*out)[3]) {
    clock_begin(CLOCK_PROBE);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    double(*served)[3] = (double(*)[3])ibm->by_marker, (*read)[3] = ibm->increment;
    ibm_transfer_read(ibm, u, 1, read);
    for (int h = 0; h < ibm->served; h++) memcpy(served[ibm->arrival[h]], read[h], sizeof *read);
    memset(out, 0, (size_t)ibm->route.n * sizeof *out);
    par_exchange_backward(ibm->route.plan, served, out, sizeof *served);
    clock_end(CLOCK_PROBE);
}

/* The increments of the markers first .. last-1 by their values, which lie in the order of arrival. */
static void weigh(const struct transfer *w, int first, int last) {
    struct ibm *ibm = w->ibm;
    for (int h = first; h < last; h++) {
        const double volume = h < ibm->inner ? ibm->stencil[h].volume : ibm->edge[h - ibm->inner].volume;
        for (int c = 0; c < 3; c++) ibm->increment[h][c] = volume * w->strength[ibm->arrival[h]][c];
    }
}

static void spread_part(int thread, void *data) {
    const struct transfer *w = data;
    int from, to;
    threads_share(w->ibm->served, 1, thread, &from, &to);
    weigh(w, from, to);
    ibm_slabs_share(w->ibm, thread, &from, &to);
    ibm_slabs_write_part(w->ibm, w->u, from, to);
}

void ibm_transfer_spread(struct ibm *ibm, int r, double *const u[3], const double (*value)[3], double sum[3],
                         double whole[3]) {
    clock_begin(CLOCK_PROBE);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    par_exchange_forward(ibm->route.plan, value, ibm->by_marker, sizeof *value);
    struct transfer w = {.ibm = ibm, .u = u, .strength = (const double(*)[3])ibm->by_marker};
    threads_run(spread_part, &w);
    for (int c = 0; c < 3; c++) sum[c] = whole[c] = 0;
    for (int h = 0; h < ibm->served; h++) {
        const struct ibm_edge *edge = h < ibm->inner ? NULL : &ibm->edge[h - ibm->inner];
        for (int c = 0; c < 3; c++) ibm->received[h][c] = (r == 0 ? 0 : ibm->received[h][c]) + ibm->increment[h][c];
        if (edge && !edge->mine) continue;
        for (int c = 0; c < 3; c++) {
            sum[c] += ibm->increment[h][c] * (edge ? edge->share[c] : 1);
            whole[c] += ibm->increment[h][c];
        }
    }
    clock_end(CLOCK_PROBE);
}
