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

static void forget(struct ibm *b) {
    ibm_buffer_reserve(&b->home, &b->home_size, 3 * (size_t)b->route.n + 1);
    memset(b->home, 0, 3 * (size_t)b->route.n * sizeof *b->home);
}

void ibm_demand_home(struct ibm *b) {
    double(*served)[3] = scratch(b);
    forget(b);
    if (!b->route.plan) return;
    for (int h = 0; h < b->served; h++) memcpy(served[b->arrival[h]], b->vector[IBM_DEMAND][h], sizeof *served);
    par_exchange_backward(b->route.plan, served, b->home, sizeof *served);
}

void ibm_demand_out(struct ibm *b, int same) {
    if (!b->route.plan) return;
    double(*served)[3] = scratch(b);
    if (!same) forget(b);
    par_exchange_forward(b->route.plan, b->home, served, sizeof *served);
    for (int h = 0; h < b->served; h++) memcpy(b->vector[IBM_DEMAND][h], served[b->arrival[h]], sizeof *served);
}

int ibm_demand_is_set(const struct ibm *b) { return b->route.plan != NULL; }

void ibm_demand(struct ibm *b, double *const demand[3]) {
    ibm_demand_home(b);
    for (int i = 0; i < b->route.n; i++)
        for (int c = 0; c < 3; c++) demand[c][i] = isfinite(b->home[3 * i + c]) ? b->home[3 * i + c] : 0;
}

void ibm_demand_set(struct ibm *b, const double *const demand[3]) {
    for (int i = 0; i < b->route.n; i++)
        for (int c = 0; c < 3; c++) b->home[3 * i + c] = demand[c][i];
    ibm_demand_out(b, 1);
}
