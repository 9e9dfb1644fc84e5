/* Terzaghi's consolidation of a porous column. */
#pragma once
#include "cracks/cracks.h"
#include "physics/consolidation.h"
#include "solid/step/integrate.h"
#include "tests/cracks/porous.h"

enum { HEIGHT = 32, DEEP = 3, LAYERS = 2 * HEIGHT - 1 + 2 * DEEP };

/* Displacement of the upper drained plane against the lower one, m; positive when the column is shorter. */
static inline double settlement(const struct solid *s) {
    double sum[2] = {0, 0};
    for (int h = 0; h < s->n; h++) {
        const int layer = (int)floor(s->x0[1][h] / SPACING);
        if (layer == DEEP - 1) sum[0] += s->d[1][h];
        if (layer == LAYERS - DEEP) sum[0] -= s->d[1][h];
        sum[1] += layer == DEEP - 1;
    }
    par_sum_array(sum, 2);
    return sum[0] / sum[1];
}

/* A column of twice the height, drained and loaded at both ends: its middle is the base. The drained ends are as deep
 * as the horizon, so that every layer between them has whole families; the pressure in them falls from that of the
 * sealed column to 0. Inertia is small: the time H^2/c is `waves` times that of a wave through the height. The damping
 * of the sealed column would add to the pores' resistance, so that little of it is left when the column drains. */
static inline void terzaghi(double biot, double modulus, int waves, double from, double until) {
    const double load = 3e6, n = LAYERS * SPACING, height = HEIGHT * SPACING, viscosity = 1e-3, dt = porous_dt();
    struct solid *s = porous_column(LAYERS, load, DEEP);
    const double K = porous_confined(s), storage = 1 / modulus + biot * biot / K, wave = height * sqrt(DENSITY / K);
    const double period = waves * wave, mobility = storage * height * height / period;
    const double undrained = load * biot / K / storage, sealed = 600 * dt, start = sealed + 0.5 * wave;
    const double t[3] = {0, sealed, sealed + wave}, factor[3] = {1, 1, 0};
    const struct solid_time time = {3, t, factor};
    const struct cracks_injection end[2] = {
        {.high = {1, DEEP * SPACING, 1}, .is_pressure = 1, .value = undrained, .time = time},
        {.low = {0, n - DEEP * SPACING, 0}, .high = {1, n, 1}, .is_pressure = 1, .value = undrained, .time = time}};
    const struct cracks_input input = {.viscosity = viscosity,
                                       .least_aperture = 1e-8,
                                       .least_pressure = -1e9,
                                       .porous = 1,
                                       .pores = {mobility * viscosity, biot, modulus},
                                       .injections = 2,
                                       .injection = end};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_absolute = porous_damping(LAYERS)};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    if (isfinite(modulus)) c->in.pores.permeability = 0; /* else that has to smooth the pressure */
    solid_integrate(s, dt, 600);
    c->in.pores.permeability = input.pores.permeability;
    s->stage.damping_absolute /= 4;
    const double first = settlement(s), drained = load * 2 * height / K;
    check_relative(porous_pressure(c, LAYERS / 2), undrained, 1e-3);
    const double T[] = {0.01, 0.05, 0.1, 0.2, 0.5, 1, 2};
    for (size_t k = 0; k < sizeof T / sizeof T[0] && T[k] <= until; k++) {
        if (T[k] < from) continue;
        solid_integrate(s, dt, (int)lrint((start + T[k] * period - s->t) / dt));
        assert_int_equal(c->status.failed, 0);
        const double now = (s->t - start) / period;
        const double p = porous_pressure(c, LAYERS / 2) / undrained, U = (settlement(s) - first) / (drained - first);
        check_close(p, physics_consolidation_terzaghi(1, now), 0.02);
        check_close(U, physics_consolidation_degree(now), 0.02);
    }
    cracks_free(c);
    solid_free(s);
}
