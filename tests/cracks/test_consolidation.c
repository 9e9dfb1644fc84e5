/* Terzaghi's consolidation of a porous column. */
#include "cracks/project.h"
#include "cracks/solve.h"
#include "physics/consolidation.h"
#include "solid/step/integrate.h"
#include "tests/cracks/porous.h"

#include <stdio.h>

enum { HEIGHT = 32, DEEP = 3, LAYERS = 2 * HEIGHT - 1 + 2 * DEEP };

/* Displacement of the upper drained plane against the lower one, m; positive when the column is shorter. */
static double settlement(const struct solid *s) {
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
 * as the horizon, so that every layer between them has whole families. Inertia is small: the time H^2/c is 50 times
 * that of a wave. The damping of the sealed column is off while it drains, since it would add to the pores' resistance.
 */
static void terzaghi(double biot, double modulus, double until) {
    const double load = 3e6, n = LAYERS * SPACING, height = HEIGHT * SPACING, viscosity = 1e-3;
    struct solid *s = porous_column(LAYERS, load, DEEP);
    const double K = porous_confined(s), storage = 1 / modulus + biot * biot / K;
    const double period = 50 * height * sqrt(DENSITY / K), mobility = storage * height * height / period;
    const struct cracks_injection end[2] = {
        {.high = {1, DEEP * SPACING, 1}, .is_pressure = 1},
        {.low = {0, n - DEEP * SPACING, 0}, .high = {1, n, 1}, .is_pressure = 1}};
    const struct cracks_input input = {.viscosity = viscosity,
                                       .least_aperture = 1e-8,
                                       .least_pressure = -1e9,
                                       .porous = 1,
                                       .pores = {0, biot, modulus},
                                       .injections = 2,
                                       .injection = end};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_absolute = porous_damping(LAYERS)};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    solid_integrate(s, porous_dt(), isinf(modulus) ? 1 : 600);
    s->stage.damping_absolute = 0;
    c->in.pores.permeability = mobility * viscosity;
    const double start = s->t, first = isinf(modulus) ? 0 : settlement(s), undrained = load * biot / K / storage;
    const double drained = load * 2 * height / K;
    check_relative(porous_pressure(c, LAYERS / 2), undrained, 0.01);
    const double T[] = {0.01, 0.05, 0.1, 0.2, 0.5, 1, 2};
    for (size_t k = 0; k < sizeof T / sizeof T[0] && T[k] <= until; k++) {
        const int steps = (int)lrint((start + T[k] * period - s->t) / porous_dt());
        solid_integrate(s, porous_dt(), steps);
        assert_int_equal(c->status.failed, 0);
        const double now = (s->t - start) / period;
        const double p = porous_pressure(c, LAYERS / 2) / undrained, U = (settlement(s) - first) / (drained - first);
        if (par_rank() == 0)
            fprintf(stderr, "T %.3f p %.6f %.6f  U %.6f %.6f  it %.1f\n", now, p, physics_consolidation_terzaghi(1, now), U,
                   physics_consolidation_degree(now), (double)c->iterations / (double)c->steps);
        check_close(p, physics_consolidation_terzaghi(1, now), 0.02);
        check_close(U, physics_consolidation_degree(now), 0.02);
    }
    cracks_free(c);
    solid_free(s);
}

static void incompressible(void **state) {
    (void)state;
    terzaghi(1, INFINITY, 2);
}

static void compressible(void **state) {
    (void)state;
    terzaghi(0.8, 2 * YOUNG, 2);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(incompressible), cmocka_unit_test(compressible)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
