/* Normal probe: pressure and stress at the wall from the flow at the probe's tip.  (001: sec. 3.5.3) */
/* Pressure and stress at the root m, from the flow around the tip e = m + dl n.  (001: sec. 3.5.3)
 *
 * In both forms p|m = p|e - dl/2 (dp/dn|m + dp/dn|e). The paper's form is that of a boundary layer: dp/dn|m = rho (f -
 * dV/dt).n, and the stress is taken at the tip. The relative error of both is of the order of dl over the body's size.
 * The form extrapolated to the wall keeps the viscous part of the momentum equation there,
 *
 *      dp/dn|m = rho (f - dV/dt).n + mu n.lap u|m,      mu n.lap u|m = dp/dn|e - dl d2p/dn2|e - rho (f - dV/dt).n,
 *
 * which leaves an error of third order. The shear that is computed from the wall's velocity (ibm/tip.c) has the same
 * order. */
#include "base/clock.h"
#include "base/par.h"
#include "ibm/cell.h"
#include "ibm/state.h"

enum { SENT = IBM_TIP_SENT, RETURNED = IBM_TIP_RETURNED };
/* Number of cells that a tip's blocks reach before and behind its own cell, and ghost layers for them. */
enum { BEFORE = 2, BEHIND = 2, LAYERS = 2 };

/* Values that all ranks agree on: whether a new plan is needed; the farthest cells of all tips, the low ones
 * negated. */
enum { RENEW, LOW, HIGH = LOW + 3, AGREED = HIGH + 3 };

/* Makes the tips' items and finds the ranks that serve them; agreed [AGREED]: this rank's values. */
static void set_out(const struct ibm *ibm, const struct ibm_probe_input *in, const double length[3],
                    struct ibm_route *route, double *agreed) {
    const struct fluid_grid *g = ibm->grid;
    for (int h = 0; h < in->n; h++) {
        double *item = route->mine + (size_t)h * SENT;
        int cell[3];
        for (int d = 0; d < 3; d++) {
            item[d] = ibm_cell_wrap(g, d, in->x[d][h] + length[d] * in->normal[d][h]);
            item[IBM_TIP_NORMAL + d] = in->normal[d][h];
            item[IBM_TIP_VELOCITY + d] = in->velocity[d] ? in->velocity[d][h] : 0;
            cell[d] = ibm_cell(g, d, item[d]);
        }
        const int is_out = cell[0] < 0 || cell[1] < 0 || cell[2] < 0;
        const int dest = is_out ? -1 : ibm->owner[1][cell[1]] + ibm->owner[2][cell[2]];
        if (dest != route->key[h]) agreed[RENEW] = 1;
        route->key[h] = dest;
        for (int d = 0; d < 3 && !is_out; d++) {
            if (-cell[d] > agreed[LOW + d]) agreed[LOW + d] = -cell[d];
            if (cell[d] > agreed[HIGH + d]) agreed[HIGH + d] = cell[d];
        }
    }
}

/* Fills the ghosts of the state that the tips read. */
static void refresh(struct ibm *ibm, const double *agreed) {
    int low[3], high[3];
    for (int d = 0; d < 3; d++) {
        low[d] = (int)-agreed[LOW + d] - BEFORE;
        high[d] = (int)agreed[HIGH + d] + BEHIND + 1;
    }
    fluid_state_refresh_near(ibm->fluid, LAYERS, low, high);
}

/* Sends the tips to their ranks and gets their results back. back [n][RETURNED] */
static const double *exchange(struct ibm *ibm, const struct ibm_probe_input *in, const double length[3]) {
    const double nowhere = -1e6; /* cells */
    const struct fluid_input *fluid = fluid_input_of(ibm->fluid);
    struct ibm_route *route = &ibm->probe;
    double agreed[AGREED] = {ibm_route_reserve(route, in->n, SENT + RETURNED)};
    for (int a = LOW; a < AGREED; a++) agreed[a] = nowhere;
    double *sent = route->mine, *back = sent + (size_t)in->n * SENT;
    set_out(ibm, in, length, route, agreed);
    par_max_array(agreed, AGREED);
    if (agreed[RENEW] > 0) {
        for (int h = 0; h < in->n; h++) route->dest[h] = (int)route->key[h];
        route->plan = par_exchange_renew(route->plan, in->n, NULL, route->dest);
    }
    refresh(ibm, agreed);
    const size_t served = (size_t)par_exchange_count(route->plan);
    ibm_buffer_reserve(&route->served, &route->served_size, served * (SENT + RETURNED) + 1);
    par_exchange_forward(route->plan, sent, route->served, SENT * sizeof(double));
    double *result = route->served + served * SENT;
    const struct ibm_tip_form form = {
        .density = fluid->density, .mu = fluid->density * fluid->viscosity, .length = in->velocity[0] ? length[0] : 0};
    /* in order of arrival, in which neighbouring tips have close numbers */
    ibm_tip_measure(ibm->grid, fluid_state_of(ibm->fluid), &form, served, route->served, result);
    par_exchange_backward(route->plan, result, back, RETURNED * sizeof(double));
    return back;
}

/* mu n.lap u at the wall, limited. Without slip it is at most of the order of mu |u - V|/l2 (factor 2 near the
 * stagnation point of a plane, 5 near that of a sphere of four cells in diameter). If the tip reaches into another
 * wall, dp/dn contains the pressure jump there; the limit cuts it off. push: force per volume that the solved pressure
 * balances, along n; acceleration: dV/dt.n */
static double viscous(const double *e, double density, double push, double acceleration) {
    static const double MOST = 6;
    const double all = e[IBM_TIP_WALL_SLOPE] + density * acceleration - push;
    const double most = MOST * e[IBM_TIP_SCALE];
    return fmax(-most, fmin(most, all));
}

void ibm_probe(struct ibm *ibm, const struct ibm_probe_input *in, double *const traction[3], double *pressure,
               uint8_t *active) {
    clock_begin(CLOCK_PROBE);
    const struct fluid_input *fluid = fluid_input_of(ibm->fluid);
    double length[3], push[3], gradient[3] = {0, 0, 0};
    for (int d = 0; d < 3; d++) length[d] = in->length * ibm->grid->d[d];
    const double dl = length[0];
    /* forces per volume that the solved pressure balances in a fluid at rest */
    if (fluid->driving.type != FLUID_DRIVING_NONE)
        for (int c = 0; c < 3; c++) gradient[c] = fluid_driving_along(fluid, c) * fluid_state_of(ibm->fluid)->driven;
    for (int d = 0; d < 3; d++) push[d] = fluid->density * fluid->body_force[d] + gradient[d];
    const double *back = exchange(ibm, in, length);
    for (int h = 0; h < in->n; h++) {
        active[h] = ibm->probe.key[h] >= 0;
        pressure[h] = 0;
        for (int c = 0; c < 3; c++) traction[c][h] = 0;
        if (!active[h]) continue;
        const double *e = back + (size_t)h * RETURNED;
        const double acceleration = in->acceleration_n ? in->acceleration_n[h] : 0;
        double push_n = 0, drive = 0;
        for (int d = 0; d < 3; d++) {
            push_n += push[d] * in->normal[d][h];
            drive += gradient[d] * in->x[d][h];
        }
        /* dp/dn|m for an outward n  (001: eqs 3.85, 3.87, mended) */
        double at_root = push_n - (in->is_carried ? 0 : fluid->density * acceleration);
        if (in->velocity[0]) at_root += viscous(e, fluid->density, push_n, acceleration);
        pressure[h] = e[0] - 0.5 * dl * (at_root + e[IBM_TIP_SLOPE]) - drive;
        for (int c = 0; c < 3; c++) traction[c][h] = e[IBM_TIP_STRESS + c] - pressure[h] * in->normal[c][h];
    }
    clock_end(CLOCK_PROBE);
}
