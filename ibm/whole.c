/* Reading and writing of all markers' values, inner ones and edges, in one go. */
#include "base/clock.h"
#include "ibm/state.h"

#include <string.h>

void ibm_whole_read(struct ibm *ibm, double *const u[3], int with_sides, double (*velocity)[3]) {
    ibm_sweep_read(ibm, u, 0, ibm->inner, velocity);
    ibm_edge_sum(ibm, u, 0, ibm->pieces);
    ibm_share_sums(ibm);
    ibm_edge_velocity(ibm, with_sides, velocity + ibm->inner);
}

void ibm_whole_write(struct ibm *ibm, double *const u[3], const double (*strength)[3]) {
    memcpy(ibm->increment, strength, (size_t)ibm->served * sizeof *strength);
    ibm_sweep_scatter(ibm, u, 0, ibm->inner);
    ibm_edge_scatter(ibm, u, 0, ibm->pieces);
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
