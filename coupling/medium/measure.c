/* Porosity, pressure drop, permeability and tortuosity of the medium.  (001: sec. 2.1) */
#include "base/clock.h"
#include "base/par.h"
#include "coupling/medium/parts.h"

#include <math.h>

/* Sums over all ranks; without a fluid only the solid's. Collective. */
static struct medium_sums sums_of(const struct medium *m, struct fluid *f) {
    const struct fluid_grid *g = m->g;
    const size_t origin = fluid_grid_at(g, 0, 0, 0);
    const double *const weight[3] = {m->weight[0], m->weight[1], m->weight[2]};
    struct medium_sums s = {0};
    if (f) {
        const struct fluid_state *q = fluid_state_of(f);
        s = medium_kernels_sum_flow(g->m, g->row, g->plane, weight, m->fraction + origin, q->u + origin, q->v + origin,
                                    q->w + origin);
    }
    s.solid = medium_kernels_sum_solid(g->m, g->row, g->plane, weight, m->fraction + origin);
    double all[4] = {s.solid, s.u, s.pore_u, s.pore_speed};
    par_sum_array(all, 4);
    return (struct medium_sums){.solid = all[0], .u = all[1], .pore_u = all[2], .pore_speed = all[3]};
}

static double porosity_from(const struct medium *m, const struct medium_sums *s) { return 1 - s->solid / m->total; }

static double tortuosity_from(const struct medium_sums *s) { return s->pore_u == 0 ? NAN : s->pore_speed / s->pore_u; }

/* (001: eq. 2.4) with Q/S the mean velocity over the box. */
static double permeability_from(const struct medium *m, struct fluid *f, const struct medium_sums *s, double drop) {
    const struct fluid_input *in = fluid_input_of(f);
    if (drop == 0) return NAN;
    return s->u / m->total * (m->high[0] - m->low[0]) * in->density * in->viscosity / drop;
}

double medium_measure_porosity(const struct medium *m) {
    const struct medium_sums s = sums_of(m, NULL);
    return porosity_from(m, &s);
}

double medium_measure_tortuosity(const struct medium *m, struct fluid *f) {
    const struct medium_sums s = sums_of(m, f);
    return tortuosity_from(&s);
}

double medium_measure_permeability(struct medium *m, struct fluid *f) {
    const struct medium_sums s = sums_of(m, f);
    return permeability_from(m, f, &s, medium_measure_pressure_drop(m, f));
}

/* The part of the driving along x that p does not contain, Pa/m. */
static double driving_along_x(struct fluid *f) {
    const struct fluid_input *in = fluid_input_of(f);
    const int driven = in->driving.type != FLUID_DRIVING_NONE && in->driving.direction == 0;
    return (driven ? fluid_state_of(f)->driven : 0) + in->density * in->body_force[0];
}

double medium_measure_pressure_drop(struct medium *m, struct fluid *f) {
    const struct fluid_grid *g = m->g;
    const struct fluid_input *in = fluid_input_of(f);
    const double driving = driving_along_x(f), driven = driving * (m->high[0] - m->low[0]);
    if (m->whole_period || g->n[0] < 2) return driven;
    if (g->periodic[0] && !medium_face_is_clear(m, 0)) return driving * g->length[0];
    fluid_measures_mean_pressure(f, 0, m->section);
    return medium_face_pressure(m, in, driving, 0) - medium_face_pressure(m, in, driving, 1) + driven;
}

double medium_measure_specific_surface(const struct medium *m, double immersed_area) {
    return immersed_area / ((m->high[0] - m->low[0]) * (m->high[1] - m->low[1]) * (m->high[2] - m->low[2]));
}

struct medium_values medium_measure(struct medium *m, struct fluid *f, double immersed_area) {
    clock_begin(CLOCK_OUTPUT);
    const struct medium_sums s = sums_of(m, f);
    const double drop = medium_measure_pressure_drop(m, f);
    const struct medium_values value = {
        .porosity = porosity_from(m, &s),
        .porosity_effective = medium_connect_porosity(m),
        .pressure_drop = drop,
        .velocity = s.u / m->total,
        .permeability = permeability_from(m, f, &s, drop),
        .tortuosity = tortuosity_from(&s),
        .specific_surface = medium_measure_specific_surface(m, immersed_area),
    };
    clock_end(CLOCK_OUTPUT);
    return value;
}
