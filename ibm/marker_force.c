/* The force that each marker keeps from step to step: with feedback the force itself, with implicit diffusion the
 * starting guess of its iteration. It belongs to the particle, and is restored after a new sort of the markers. */
#include "ibm/state.h"

#include <math.h>
#include <string.h>

/* Scratch, [served][3]. */
static double (*scratch(struct ibm *b))[3] {
    ibm_buffer_reserve(&b->by_marker, &b->by_marker_size, 3 * (size_t)b->served + 1);
    return (double(*)[3])b->by_marker;
}

static void clear(struct ibm *ibm) {
    ibm_buffer_reserve(&ibm->marker_force, &ibm->marker_force_size, 3 * (size_t)ibm->route.n + 1);
    memset(ibm->marker_force, 0, 3 * (size_t)ibm->route.n * sizeof *ibm->marker_force);
}

void ibm_marker_force_collect(struct ibm *ibm) {
    double(*served)[3] = scratch(ibm);
    clear(ibm);
    if (!ibm->route.plan) return;
    for (int h = 0; h < ibm->served; h++)
        memcpy(served[ibm->arrival[h]], ibm->vector[IBM_MARKER_FORCE][h], sizeof *served);
    par_exchange_backward(ibm->route.plan, served, ibm->marker_force, sizeof *served);
}

void ibm_marker_force_distribute(struct ibm *ibm, int same) {
    if (!ibm->route.plan) return;
    double(*served)[3] = scratch(ibm);
    if (!same && !ibm->marker_force_is_next) clear(ibm);
    ibm->marker_force_is_next = 0;
    par_exchange_forward(ibm->route.plan, ibm->marker_force, served, sizeof *served);
    for (int h = 0; h < ibm->served; h++)
        memcpy(ibm->vector[IBM_MARKER_FORCE][h], served[ibm->arrival[h]], sizeof *served);
}

int ibm_marker_force_is_kept(const struct ibm *ibm) { return ibm->implicit || ibm->slip_time > 0; }

int ibm_marker_force_is_set(const struct ibm *b) { return b->route.plan != NULL; }

void ibm_marker_force_get(struct ibm *ibm, double *const force[3]) {
    ibm_marker_force_collect(ibm);
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++)
            force[c][i] = isfinite(ibm->marker_force[3 * i + c]) ? ibm->marker_force[3 * i + c] : 0;
}

void ibm_marker_force_set(struct ibm *ibm, const double *const force[3]) {
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++) ibm->marker_force[3 * i + c] = force[c][i];
    ibm_marker_force_distribute(ibm, 1);
}

void ibm_marker_force_set_next(struct ibm *ibm, int n, const double *const force[3]) {
    ibm_buffer_reserve(&ibm->marker_force, &ibm->marker_force_size, 3 * (size_t)n + 1);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) ibm->marker_force[3 * i + c] = force[c][i];
    ibm->marker_force_is_next = 1;
}
