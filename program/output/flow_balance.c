/* The balances of momentum and energy of a flow without bodies. */
#include "program/output/flow_balance.h"
#include "coupling/control/sample_watch.h"
#include "coupling/run.h"

#include <math.h>

/* Largest change of the dissipation in a step, over the dissipation: the mean of both ends is right to a thousandth. */
static const double STEADY = 0.1;

void flow_balance_prepare(struct flow_balance *b, struct run *r) {
    b->rows++;
    if (b->rows & (b->rows - 1)) return; /* a fault of the scheme is in every step */
    b->before = fluid_measures_of(r->fluid);
    fluid_box_force_begin(r->fluid);
    b->prepared = 1;
}

void flow_balance_cancel(struct flow_balance *b, struct run *r) {
    double force[3];
    if (b->prepared) fluid_box_force_end(r->fluid, force);
    b->prepared = 0;
}

static double length_of(const double x[3]) { return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

double flow_balance_least_force(struct run *r, double kinetic_energy) {
    static const double LEAST = 1e-6;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double mass = fluid_input_of(r->fluid)->density * g->length[0] * g->length[1] * g->length[2];
    return LEAST * (sqrt(2 * kinetic_energy * mass) / r->dt + fluid_box_force_size(r->fluid));
}

static void check_momentum(const struct flow_balance *b, struct run *r, const struct fluid_measures *now) {
    double force[3], off[3];
    fluid_box_force_end(r->fluid, force);
    for (int c = 0; c < 3; c++) off[c] = (now->momentum[c] - b->before.momentum[c]) / r->dt - force[c];
    sample_watch_momentum(r, length_of(off), fmax(length_of(force), flow_balance_least_force(r, now->kinetic_energy)));
}

/* Whether viscosity and the source alone change the kinetic energy: all sides are periodic, slip, or walls at rest, and
 * the source is constant. */
static int is_closed(const struct fluid_input *in) {
    const int held = in->driving.type == FLUID_DRIVING_BULK;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_side *s = &in->side[d][side];
            if (s->type == FLUID_WALL && length_of(s->velocity) == 0) continue;
            if (s->type != FLUID_PERIODIC && s->type != FLUID_SLIP) return 0;
        }
    return !held && !in->implicit && in->projection == FLUID_EACH_STAGE && !(in->driving_frequency > 0);
}

/* Convection and pressure take no energy from a flow that is free of divergence. */
static void check_energy(const struct flow_balance *b, struct run *r, const struct fluid_measures *now) {
    const struct fluid_measures *from = &b->before;
    const double lost = 0.5 * (from->dissipation + now->dissipation),
                 gained = (now->kinetic_energy - from->kinetic_energy) / r->dt;
    double given = 0;
    if (!is_closed(fluid_input_of(r->fluid)) || fabs(now->dissipation - from->dissipation) > STEADY * lost) return;
    for (int c = 0; c < 3; c++) given += fluid_source(r->fluid, c) * 0.5 * (from->momentum[c] + now->momentum[c]);
    sample_watch_energy(r, gained + lost - given, lost);
}

void flow_balance_check(struct flow_balance *b, struct run *r, const struct fluid_measures *now) {
    if (!b->prepared) return;
    b->prepared = 0;
    check_momentum(b, r, now);
    check_energy(b, r, now);
}
