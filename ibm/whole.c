/* Reading and writing of all markers' values, inner ones and edges, in one go. */
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
