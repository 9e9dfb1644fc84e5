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
#include "base/threads.h"
#include "ibm/cell.h"
#include "ibm/state.h"

enum { SENT = IBM_TIP_SENT, RETURNED = IBM_TIP_RETURNED };
/* Number of cells that a tip's blocks reach before and behind its own cell, and ghost layers for them. */
enum { BEFORE = 2, BEHIND = 2, LAYERS = 2 };
enum { CHUNK = 64 }; /* tips of this rank whose items and results stay in the first-level cache: 8 KB */

/* Values that all ranks agree on: whether a new plan is needed; the farthest cells of all tips, the low ones
 * negated. */
enum { RENEW, LOW, HIGH = LOW + 3, AGREED = HIGH + 3 };

/* What the parts of a call share. */
struct call {
    struct ibm *ibm;
    const struct ibm_probe_input *in;
    struct ibm_tip_form form;
    double length[3];        /* of a probe, m */
    double push[3];          /* force per volume that the solved pressure balances in a fluid at rest */
    double gradient[3];      /* part of it by the driving */
    double *const *traction; /* outputs, as ibm_probe */
    double *pressure;
    uint8_t *active;
    size_t served; /* tips of other ranks */
};

static double tip_at(const struct call *a, int d, int h) {
    return ibm_cell_wrap(a->ibm->grid, d, a->in->x[d][h] + a->length[d] * a->in->normal[d][h]);
}

static void item_set(const struct call *a, int h, double *item) {
    const double *tip = a->ibm->probe.mine + (size_t)3 * (size_t)h;
    for (int d = 0; d < 3; d++) {
        item[d] = tip[d];
        item[IBM_TIP_NORMAL + d] = a->in->normal[d][h];
        item[IBM_TIP_VELOCITY + d] = a->in->velocity[d] ? a->in->velocity[d][h] : 0;
    }
}

/* Finds the tips, in cells, and the ranks that serve them; agreed [AGREED]: this rank's values. */
static void find_ranks(const struct call *a, double *agreed) {
    const struct ibm *ibm = a->ibm;
    const struct fluid_grid *g = ibm->grid;
    long *key = ibm->probe.key;
    for (int h = 0; h < a->in->n; h++) {
        int cell[3];
        double *tip = ibm->probe.mine + (size_t)3 * (size_t)h;
        for (int d = 0; d < 3; d++) {
            tip[d] = tip_at(a, d, h);
            cell[d] = ibm_cell(g, d, tip[d]);
        }
        const int is_out = cell[0] < 0 || cell[1] < 0 || cell[2] < 0;
        const int dest = is_out ? -1 : ibm->owner[1][cell[1]] + ibm->owner[2][cell[2]];
        if (dest != key[h]) agreed[RENEW] = 1;
        key[h] = dest;
        for (int d = 0; d < 3 && !is_out; d++) {
            if (-cell[d] > agreed[LOW + d]) agreed[LOW + d] = -cell[d];
            if (cell[d] > agreed[HIGH + d]) agreed[HIGH + d] = cell[d];
        }
    }
}

/* Plans the exchange of the tips that other ranks serve. */
static void renew_plan(struct ibm *ibm) {
    struct ibm_route *route = &ibm->probe;
    const int me = par_rank();
    ibm->away = 0;
    for (int h = 0; h < route->n; h++)
        if (route->key[h] >= 0 && route->key[h] != me) {
            route->item[ibm->away] = h;
            route->dest[ibm->away++] = (int)route->key[h];
        }
    route->plan = par_exchange_renew(route->plan, ibm->away, NULL, route->dest);
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

/* Pressure and traction of probe h from the values e at its tip. */
static void finish(const struct call *a, int h, const double *e) {
    const struct ibm_probe_input *in = a->in;
    const double density = a->form.density, acceleration = in->acceleration_n ? in->acceleration_n[h] : 0;
    double push_n = 0, drive = 0;
    for (int d = 0; d < 3; d++) {
        push_n += a->push[d] * in->normal[d][h];
        drive += a->gradient[d] * in->x[d][h];
    }
    /* dp/dn|m for an outward n  (001: eqs 3.85, 3.87, mended) */
    double at_root = push_n - (in->is_carried ? 0 : density * acceleration);
    if (in->velocity[0]) at_root += viscous(e, density, push_n, acceleration);
    a->pressure[h] = e[0] - 0.5 * a->length[0] * (at_root + e[IBM_TIP_SLOPE]) - drive;
    for (int c = 0; c < 3; c++) a->traction[c][h] = e[IBM_TIP_STRESS + c] - a->pressure[h] * in->normal[c][h];
}

/* A thread's part of the tips of this rank's own probes, in chunks, and of those of other ranks. Tips keep the order in
 * which they are given, in which neighbouring tips have close numbers. */
static void measure_part(int thread, void *data) {
    const struct call *a = data;
    const struct ibm *ibm = a->ibm;
    const struct fluid_state *f = fluid_state_of(ibm->fluid);
    const int me = par_rank();
    double item[CHUNK][SENT], result[CHUNK][RETURNED];
    int from, to;
    threads_share(a->in->n, CHUNK, thread, &from, &to);
    for (int h = from; h < to;) {
        int mine[CHUNK], tips = 0;
        for (; h < to && tips < CHUNK; h++) {
            a->active[h] = ibm->probe.key[h] >= 0;
            if (ibm->probe.key[h] == me) mine[tips++] = h;
            if (a->active[h]) continue;
            a->pressure[h] = 0;
            for (int c = 0; c < 3; c++) a->traction[c][h] = 0;
        }
        for (int i = 0; i < tips; i++) item_set(a, mine[i], item[i]);
        ibm_tip_measure(ibm->grid, f, &a->form, tips, item[0], result[0]);
        for (int i = 0; i < tips; i++) finish(a, mine[i], result[i]);
    }
    threads_share((int)a->served, CHUNK, thread, &from, &to);
    const double *served = ibm->probe.served;
    ibm_tip_measure(ibm->grid, f, &a->form, to - from, served + (size_t)from * SENT,
                    ibm->probe.served + a->served * SENT + (size_t)from * RETURNED);
}

/* Measures all tips. Those in the cells of other ranks are sent there, and their results are sent back. */
static void measure(struct call *a) {
    const double nowhere = -1e6; /* cells */
    struct ibm *ibm = a->ibm;
    struct ibm_route *route = &ibm->probe;
    double agreed[AGREED] = {ibm_route_reserve(route, a->in->n, 3)};
    for (int i = LOW; i < AGREED; i++) agreed[i] = nowhere;
    find_ranks(a, agreed);
    par_max_array(agreed, AGREED);
    if (agreed[RENEW] > 0) renew_plan(ibm);
    refresh(ibm, agreed);
    a->served = (size_t)par_exchange_count(route->plan);
    ibm_buffer_reserve(&route->served, &route->served_size, a->served * (SENT + RETURNED) + 1);
    ibm_buffer_reserve(&ibm->away_item, &ibm->away_size, (size_t)ibm->away * (SENT + RETURNED) + 1);
    double *back = ibm->away_item + (size_t)ibm->away * SENT;
    for (int i = 0; i < ibm->away; i++) item_set(a, route->item[i], ibm->away_item + (size_t)i * SENT);
    par_exchange_forward(route->plan, ibm->away_item, route->served, SENT * sizeof(double));
    threads_run(measure_part, a);
    par_exchange_backward(route->plan, route->served + a->served * SENT, back, RETURNED * sizeof(double));
    for (int i = 0; i < ibm->away; i++) finish(a, route->item[i], back + (size_t)i * RETURNED);
}

void ibm_probe(struct ibm *ibm, const struct ibm_probe_input *in, double *const traction[3], double *pressure,
               uint8_t *active) {
    clock_begin(CLOCK_PROBE);
    const struct fluid_input *fluid = fluid_input_of(ibm->fluid);
    struct call a = {.ibm = ibm, .in = in, .traction = traction, .pressure = pressure, .active = active};
    for (int d = 0; d < 3; d++) a.length[d] = in->length * ibm->grid->d[d];
    a.form = (struct ibm_tip_form){.density = fluid->density,
                                   .mu = fluid->density * fluid->viscosity,
                                   .length = in->velocity[0] ? a.length[0] : 0};
    if (fluid->driving.type != FLUID_DRIVING_NONE)
        for (int c = 0; c < 3; c++) a.gradient[c] = fluid_driving_along(fluid, c) * fluid_state_of(ibm->fluid)->driven;
    for (int d = 0; d < 3; d++) a.push[d] = fluid->density * fluid->body_force[d] + a.gradient[d];
    measure(&a);
    clock_end(CLOCK_PROBE);
}
