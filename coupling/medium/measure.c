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
    } else {
        s.solid = medium_kernels_sum_solid(g->m, g->row, g->plane, weight, m->fraction + origin);
    }
    double all[8] = {s.solid, s.u[0], s.u[1], s.u[2], s.pore_u[0], s.pore_u[1], s.pore_u[2], s.pore_speed};
    par_sum_array(all, 8);
    for (int c = 0; c < 3 && m->pores_only; c++) all[1 + c] = all[4 + c];
    return (struct medium_sums){
        .solid = all[0], .u = {all[1], all[2], all[3]}, .pore_u = {all[4], all[5], all[6]}, .pore_speed = all[7]};
}

static double porosity_from(const struct medium *m, const struct medium_sums *s) { return 1 - s->solid / m->total; }

static double along(const struct medium *m, const double v[3]) {
    return m->along[0] * v[0] + m->along[1] * v[1] + m->along[2] * v[2];
}

/* A mean flow of less than NONE of the mean speed is round-off. */
#define NONE 1e-9
static double tortuosity_from(const struct medium *m, const struct medium_sums *s) {
    const double mean = fabs(along(m, s->pore_u));
    return mean <= NONE * s->pore_speed ? NAN : s->pore_speed / mean;
}

/* (001: eq. 2.4) with Q/S the mean velocity over the box. */
static double permeability_from(const struct medium *m, struct fluid *f, const struct medium_sums *s, double drop) {
    const struct fluid_input *in = fluid_input_of(f);
    if (drop == 0) return NAN;
    return along(m, s->u) / m->total * medium_extent(m) * in->density * in->viscosity / drop;
}

double medium_measure_porosity(const struct medium *m) {
    const struct medium_sums s = sums_of(m, NULL);
    return porosity_from(m, &s);
}

/* The part of the driving along the flow's direction that p does not contain, Pa/m. */
static double driving_along(const struct medium *m, struct fluid *f) {
    const struct fluid_input *in = fluid_input_of(f);
    const double driven = in->driving.type != FLUID_DRIVING_NONE ? fluid_state_of(f)->driven : 0;
    double sum = 0;
    for (int c = 0; c < 3; c++)
        sum += m->along[c] * (fluid_driving_along(in, c) * driven + in->density * in->body_force[c]);
    return sum;
}

double medium_measure_pressure_drop(struct medium *m, struct fluid *f) {
    const struct fluid_grid *g = m->g;
    const struct fluid_input *in = fluid_input_of(f);
    const double driving = driving_along(m, f), driven = driving * medium_extent(m);
    if (m->slanted || m->whole_period[m->axis] || g->n[m->axis] < 2) return driven;
    if (g->periodic[m->axis] && !medium_face_is_clear(m, 0)) return driving * g->length[m->axis];
    fluid_measures_mean_pressure(f, m->axis, m->section);
    return medium_face_pressure(m, in, driving, 0) - medium_face_pressure(m, in, driving, 1) + driven;
}

double medium_measure_specific_surface(const struct medium *m, double immersed_area) {
    return immersed_area / ((m->high[0] - m->low[0]) * (m->high[1] - m->low[1]) * (m->high[2] - m->low[2]));
}

struct medium_values medium_measure(struct medium *m, struct fluid *f, double immersed_area) {
    clock_begin(CLOCK_OUTPUT);
    const struct medium_sums s = sums_of(m, f);
    const double drop = medium_measure_pressure_drop(m, f);
    const double k = permeability_from(m, f, &s, drop), velocity = along(m, s.u) / m->total;
    const struct medium_values value = {
        .porosity = porosity_from(m, &s),
        .porosity_effective = medium_connect_porosity(m),
        .pressure_drop = drop,
        .mean_velocity = {s.u[0] / m->total, s.u[1] / m->total, s.u[2] / m->total},
        .velocity = velocity,
        .permeability = k,
        .reynolds = fabs(velocity) * sqrt(fabs(k)) / fluid_input_of(f)->viscosity,
        .tortuosity = tortuosity_from(m, &s),
        .specific_surface = medium_measure_specific_surface(m, immersed_area),
    };
    clock_end(CLOCK_OUTPUT);
    return value;
}
