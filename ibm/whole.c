/* Reading and writing of all markers' values, inner ones and edges, in one go. */
#include "ibm/state.h"

#include <string.h>

void ibm_whole_read(struct ibm *b, double *const u[3], int with_sides, double (*velocity)[3]) {
    ibm_sweep_read(b, u, velocity);
    ibm_edge_sum(b, u, 0, b->pieces);
    ibm_share_sums(b);
    ibm_edge_velocity(b, with_sides, velocity + b->inner);
}

void ibm_whole_write(struct ibm *b, double *const u[3], const double (*strength)[3]) {
    memcpy(b->increment, strength, (size_t)b->served * sizeof *strength);
    ibm_sweep_scatter(b, u, 0, b->inner);
    ibm_edge_scatter(b, u, 0, b->pieces);
}
