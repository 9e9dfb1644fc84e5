/* Reading and writing of all markers' values, inner ones and edges, in one go. */
#include "base/clock.h"
#include "base/threads.h"
#include "ibm/state.h"

#include <string.h>

/* What the threads share: velocities that are read, or strengths that are written. */
struct whole {
    struct ibm *ibm;
    double *const *u;
    double (*velocity)[3];
    const double (*strength)[3];
};

static void read_part(int thread, void *data) {
    const struct whole *w = data;
    int from, to;
    ibm_slabs_share(w->ibm, thread, &from, &to);
    for (int s = from; s < to; s++) ibm_slabs_read(w->ibm, w->u, s, w->velocity);
}

void ibm_whole_read(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]) {
    struct whole w = {.ibm = ibm, .u = u, .velocity = velocity};
    threads_run(read_part, &w);
    ibm_slabs_finish(ibm, u, with_sides, velocity);
}

static void write_part(int thread, void *data) {
    const struct whole *w = data;
    int from, to;
    threads_share(w->ibm->served, 1, thread, &from, &to);
    memcpy(w->ibm->increment + from, w->strength + from, (size_t)(to - from) * sizeof *w->strength);
    ibm_slabs_share(w->ibm, thread, &from, &to);
    ibm_slabs_write_part(w->ibm, w->u, from, to);
}

void ibm_whole_write(struct ibm *ibm, double *const u[3], const double (*strength)[3]) {
    struct whole w = {.ibm = ibm, .u = u, .strength = strength};
    threads_run(write_part, &w);
}

void ibm_whole_sample(struct ibm *ibm, double *const u[3], double (*out)[3]) {
    clock_begin(CLOCK_PROBE);
    ibm_buffer_reserve(&ibm->by_marker, &ibm->by_marker_size, 3 * (size_t)ibm->served + 1);
    double(*served)[3] = (double(*)[3])ibm->by_marker, (*read)[3] = ibm->increment;
    ibm_whole_read(ibm, u, 1, read);
    for (int h = 0; h < ibm->served; h++) memcpy(served[ibm->arrival[h]], read[h], sizeof *read);
    memset(out, 0, (size_t)ibm->route.n * sizeof *out);
    par_exchange_backward(ibm->route.plan, served, out, sizeof *served);
    clock_end(CLOCK_PROBE);
}
