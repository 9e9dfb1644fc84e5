/* Starting guess of the implicit forcing: stored per particle, restored after a new sort of the markers or a
 * restart. */
#include "ibm/state.h"

#include <math.h>
#include <string.h>

/* Scratch, [served][3]. */
static double (*scratch(struct ibm *b))[3] {
    ibm_buffer_reserve(&b->by_marker, &b->by_marker_size, 3 * (size_t)b->served + 1);
    return (double(*)[3])b->by_marker;
}

static void forget(struct ibm *ibm) {
    ibm_buffer_reserve(&ibm->home, &ibm->home_size, 3 * (size_t)ibm->route.n + 1);
    memset(ibm->home, 0, 3 * (size_t)ibm->route.n * sizeof *ibm->home);
}

void ibm_demand_home(struct ibm *ibm) {
    double(*served)[3] = scratch(ibm);
    forget(ibm);
    if (!ibm->route.plan) return;
    for (int h = 0; h < ibm->served; h++) memcpy(served[ibm->arrival[h]], ibm->vector[IBM_DEMAND][h], sizeof *served);
    par_exchange_backward(ibm->route.plan, served, ibm->home, sizeof *served);
}

void ibm_demand_out(struct ibm *ibm, int same) {
    if (!ibm->route.plan) return;
    double(*served)[3] = scratch(ibm);
    if (!same && !ibm->home_is_set) forget(ibm);
    ibm->home_is_set = 0;
    par_exchange_forward(ibm->route.plan, ibm->home, served, sizeof *served);
    for (int h = 0; h < ibm->served; h++) memcpy(ibm->vector[IBM_DEMAND][h], served[ibm->arrival[h]], sizeof *served);
}

int ibm_demand_is_kept(const struct ibm *ibm) { return ibm->implicit || ibm->slip_time > 0; }

int ibm_demand_is_set(const struct ibm *b) { return b->route.plan != NULL; }

void ibm_demand(struct ibm *ibm, double *const demand[3]) {
    ibm_demand_home(ibm);
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++) demand[c][i] = isfinite(ibm->home[3 * i + c]) ? ibm->home[3 * i + c] : 0;
}

void ibm_demand_set(struct ibm *ibm, const double *const demand[3]) {
    for (int i = 0; i < ibm->route.n; i++)
        for (int c = 0; c < 3; c++) ibm->home[3 * i + c] = demand[c][i];
    ibm_demand_out(ibm, 1);
}

void ibm_demand_set_next(struct ibm *ibm, int n, const double *const demand[3]) {
    ibm_buffer_reserve(&ibm->home, &ibm->home_size, 3 * (size_t)n + 1);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) ibm->home[3 * i + c] = demand[c][i];
    ibm->home_is_set = 1;
}
