/* A plate in motion: conservation, loads, driven layers, energy, regular and irregular points. */
#include "base/memory.h"
#include "tests/solid/make_plate.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/measure/stress.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"
#include "tests/check.h"

/* d = g X0 + shift. */
static void deform(struct solid *s, double g[2][2]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 2; c++) s->d[c][h] = g[c][0] * s->x0[0][h] + g[c][1] * s->x0[1][h] + 1e-4;
    solid_ghosts_update(s);
}

static double most_of(const struct solid *s, double *const a[3], double inset) {
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        int in = 1;
        for (int c = 0; c < 2; c++) in &= s->x0[c][h] > inset && s->x0[c][h] < 20 * SPACING - inset;
        for (int c = 0; in && c < 2; c++) most = fmax(most, fabs(a[c][h]));
    }
    return par_max(most);
}

/* No force inside under any small affine displacement of a lattice, and nowhere in a turn of any plate. The scale is
 * the force of one row of bonds alone. */
static void test_patch(void **state) {
    (void)state;
    const double scale = YOUNG / (DENSITY * SPACING);
    for (int kind = 0; kind < 8; kind++) {
        struct solid *s = make((struct make){.sites = {20, 20},
                                             .model = kind & 1 ? PHYSICS_PLANE_STRAIN : PHYSICS_PLANE_STRESS,
                                             .partial = kind & 2 ? SOLID_PARTIAL_RAMP : SOLID_PARTIAL_EXACT,
                                             .micromodulus = kind & 4 ? PHYSICS_CONICAL : PHYSICS_CONSTANT,
                                             .uncorrected = 1});
        double g[2][2] = {{1e-6, 2e-6}, {-0.5e-6, 3e-6}};
        deform(s, g);
        solid_force(s, 0);
        check_above(most_of(s, s->a, 0), 1e-3 * scale * 1e-6);
        check_close(most_of(s, s->a, 4 * SPACING) / (scale * 1e-6), 0, 2e-5); /* of second order in the strain */
        solid_free(s);
    }
    for (int irregular = 0; irregular < 2; irregular++) {
        struct solid *s = make((struct make){.sites = {20, 20}, .irregular = 0.2 * irregular, .brittle = 1});
        double g[2][2] = {{cos(1.) - 1, -sin(1.)}, {sin(1.), cos(1.) - 1}};
        deform(s, g);
        solid_force(s, 1);
        check_close(most_of(s, s->a, 0) / scale, 0, 1e-11);
        solid_family_count(s);
        assert_int_equal(s->bonds_broken, 0);
        solid_free(s);
    }
}

/* Momentum and angular momentum over their terms' size. */
static void totals(const struct solid *s, double total[3], double *size) {
    double sum[4] = {0};
    for (int h = 0; h < s->n; h++) {
        double x[3] = {0};
        solid_position(s, h, x);
        check_equal(x[2], 0);
        const double m = DENSITY * s->volume[h];
        for (int c = 0; c < 2; c++) sum[c] += m * s->v[c][h];
        sum[2] += m * (x[0] * s->v[1][h] - x[1] * s->v[0][h]) / SPACING;
        sum[3] += m * (fabs(s->v[0][h]) + fabs(s->v[1][h]));
    }
    par_sum_array(sum, 4);
    memcpy(total, sum, 3 * sizeof *total);
    *size = sum[3];
}

static void test_momentum(void **state) {
    (void)state;
    for (int irregular = 0; irregular < 2; irregular++)
        for (int verlet = 0; verlet < 2; verlet++) {
            struct solid *s = make((struct make){.sites = {17, 12}, .irregular = 0.2 * irregular});
            s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .damping_relative = 1e16};
            shake(s, 1e-3, 1);
            double before[3], after[3], size;
            totals(s, before, &size);
            solid_integrate(s, step_of(0.5), 40);
            totals(s, after, &size);
            for (int c = 0; c < 2; c++) check_close((after[c] - before[c]) / size, 0, 1e-13);
            /* Verlet without damping would keep the other to round-off; each to its order, times the strain */
            check_close((after[2] - before[2]) / size, 0, 1e-4);
            solid_free(s);
        }
}

/* Relative residual of the energy budget of a plate that is loaded on an edge and in a region, driven at two ends and
 * damped, for a given time in a given number of steps; and the work of the driven layers. */
static double unbalanced(double irregular, int verlet, int steps) {
    const double width = 16 * SPACING;
    const double t[3] = {0, 2e-6, 9e-6}, factor[3] = {0, 1, -0.5};
    const struct solid_time time = {3, t, factor, 0};
    const struct solid_constraint constraint[2] = {
        {.low = {0, 0}, .high = {3 * SPACING, 1}, .direction = {1, 0}, .velocity = {3, 0}, .time = time},
        {.low = {width - 3 * SPACING, 0},
         .high = {1, 1},
         .direction = {1, 1},
         .has_displacement = 1,
         .displacement = {1e-6, 2e-6},
         .time = time}};
    const struct solid_load load[2] = {
        {SOLID_LOAD_REGION, .low = {5 * SPACING, 0}, .high = {9 * SPACING, 1}, .force = {1e9, 2e9}, .time = time},
        {SOLID_LOAD_REGION, .low = {0, 0}, .high = {1, 1}, .force = {0, -1e8}}};
    struct solid *s = make((struct make){.sites = {16, 10},
                                         .irregular = irregular,
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .loads = 2,
                                         .load = load});
    s->stage = (struct solid_stage){
        .integrator = verlet ? SOLID_VERLET : SOLID_RK3, .damping_relative = 3e16, .damping_absolute = 1e4};
    const double start = balance_of(s, NULL), end = 8e-6;
    double size;
    for (int i = 0; i < 8; i++) solid_integrate(s, end / steps, steps / 8);
    check_close(s->t, end, 1e-12 * end);
    const double left = fabs(balance_of(s, &size) - start) / size;
    solid_free(s);
    return left;
}

static void test_energy(void **state) {
    (void)state;
    for (int irregular = 0; irregular < 2; irregular++) {
        const double x = 0.2 * irregular;
        const double rk3 = unbalanced(x, 0, 80), verlet = unbalanced(x, 1, 80);
        check_below(rk3, 1e-3);
        check_below(verlet, 2e-3);
        check_close(log2(rk3 / unbalanced(x, 0, 160)), 3, 0.35);
        check_close(log2(verlet / unbalanced(x, 1, 160)), 2, 0.35);
    }
}

/* A driven layer is at its prescribed position at the end of every step, also if the function of time has a kink within
 * a step. */
static void test_driven(void **state) {
    (void)state;
    const double t[4] = {0, 1.3e-6, 2.1e-6, 4e-6}, factor[4] = {0, 1, 1, -2};
    const struct solid_time time = {4, t, factor, 0};
    const struct solid_constraint constraint[2] = {
        {.low = {0, 0}, .high = {3 * SPACING, 1}, .direction = {1, 0}, .velocity = {5, 0}, .time = time},
        {.low = {13 * SPACING, 0},
         .high = {1, 1},
         .direction = {0, 1},
         .has_displacement = 1,
         .displacement = {0, 3e-6},
         .time = time}};
    for (int verlet = 0; verlet < 2; verlet++) {
        struct solid *s = make((struct make){.sites = {16, 8}, .constraints = 2, .constraint = constraint});
        s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
        for (int i = 1; i <= 10; i++) {
            solid_integrate(s, 1e-7, 5);
            const double now = i * 5e-7;
            double f = now < t[1]   ? now / t[1]
                       : now < t[2] ? 1
                       : now < t[3] ? 1 - 3 * (now - t[2]) / (t[3] - t[2])
                                    : -2;
            double way = now < t[1]   ? 0.5 * f * now
                         : now < t[2] ? 0.5 * t[1] + (now - t[1])
                         : now < t[3] ? 0.5 * t[1] + (t[2] - t[1]) + 0.5 * (1 + f) * (now - t[2])
                                      : 0.5 * t[1] + (t[2] - t[1]) - 0.5 * (t[3] - t[2]) - 2 * (now - t[3]);
            for (int h = 0; h < s->n; h++) {
                if (s->flag[h] & SOLID_HELD_X) check_close(s->d[0][h], 5 * way, 1e-12 * 5e-6);
                if (s->flag[h] & SOLID_HELD_Y) check_close(s->d[1][h], 3e-6 * f, 1e-18);
            }
        }
        solid_free(s);
    }
}

/* All of a traction arrives, over one layer and over three, and pulls nothing askew; also on an edge that cuts through
 * cells. */
static void test_traction(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++)
        for (int part = 0; part < 2; part++) {
            const double from = part ? 3.3 * SPACING : 0, to = part ? 11.9 * SPACING : 16 * SPACING;
            const struct solid_load load = {SOLID_LOAD_EDGE, .edge = {{from, 10 * SPACING}, {to, 10 * SPACING}},
                                            .traction = {2e6, 5e6}, .over_horizon = over};
            struct solid *s = make((struct make){.sites = {16, 10}, .loads = 1, .load = &load});
            double sum[4] = {0};
            for (int h = 0; h < s->n; h++) {
                const double depth = 10 - s->x0[1][h] / SPACING;
                sum[3] += s->load[1][h] != 0;
                assert_true(s->load[1][h] == 0 || depth < (over ? 3 : 1));
                for (int c = 0; c < 2; c++) sum[c] += s->load[c][h] * s->volume[h];
                sum[2] += s->load[1][h] * s->volume[h] * (s->x0[0][h] - 0.5 * (from + to));
            }
            par_sum_array(sum, 4);
            const double area = (to - from) * THICKNESS;
            check_close(sum[0] / (2e6 * area), 1, 1e-11);
            check_close(sum[1] / (5e6 * area), 1, 1e-11);
            check_close(sum[2] / (5e6 * area), 0, part ? 0.5 * SPACING : 1e-12);
            if (!part) check_close(sum[3], over ? 48 : 16, 0);
            solid_free(s);
        }
}

/* A Gaussian and a sine at the start. */
static void test_initial(void **state) {
    (void)state;
    const struct solid_initial initial[] = {
        {.along = 0, .centre = 7.2 * SPACING, .width = 3 * SPACING, .displacement = {1e-5, -2e-5}},
        {SOLID_SINE, .along = 1, .centre = 0.7 * SPACING, .width = 6 * SPACING, .displacement = {3e-6, 0}}};
    struct solid *s = make((struct make){.sites = {16, 10}, .initials = 2, .initial = initial});
    for (int h = 0; h < s->n + s->n_ghost; h++) {
        const double bell = exp(-pow((s->x0[0][h] - 7.2 * SPACING) / (3 * SPACING), 2));
        const double wave = sin(2 * M_PI * (s->x0[1][h] - 0.7 * SPACING) / (6 * SPACING));
        check_close(s->d[0][h], 1e-5 * bell + 3e-6 * wave, 1e-14);
        check_close(s->d[1][h], -2e-5 * bell, 2e-14);
    }
    solid_free(s);
}

/* The stable step is: at 0.98 of it nothing grows, at 1.02 it does. */
static void test_stable(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++)
        for (int above = 0; above < 2; above++) {
            struct solid *s = make((struct make){.sites = {15, 14}, .irregular = 0.15});
            s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
            const double dt = solid_rates_stable_step(s, s->stage.integrator) * (above ? 1.02 : 0.98);
            shake(s, 1e-9, 0);
            solid_integrate(s, dt, 1500);
            double most = 0;
            for (int h = 0; h < s->n; h++) most += fabs(s->d[0][h]);
            most = par_sum(most) / (1e-9 * SPACING * (double)s->n_global);
            if (above)
                assert_false(most < 100); /* NaN too */
            else
                check_below(most, 2);
            solid_free(s);
        }
}

/* A plate at rest under tension at both ends, periodic in its width, so that it cannot contract: the strain in its
 * middle follows from C11 of the lattice. */
static void test_relaxed(void **state) {
    (void)state;
    const double w = 40 * SPACING, h = 8 * SPACING, pull = 1e6, c11 = 1.02200 * 9 / 8 * YOUNG;
    const struct solid_load load[2] = {
        {SOLID_LOAD_EDGE, .edge = {{0, 0}, {0, h}}, .traction = {-pull, 0}, .over_horizon = 1},
        {SOLID_LOAD_EDGE, .edge = {{w, 0}, {w, h}}, .traction = {pull, 0}, .over_horizon = 1}};
    struct solid *s = make((struct make){.sites = {40, 8}, .periodic = {0, 1}, .loads = 2, .load = load});
    double(*strain)[6] = malloc(((size_t)s->n + 1) * sizeof *strain);
    check_above(solid_relax(s, 1e-6, 20000), 0);
    solid_stress_strain(s, strain);
    for (int i = 0; i < s->n; i++) {
        if (fabs(s->x0[0][i] - w / 2) > 8 * SPACING) continue;
        check_close(strain[i][0] * c11 / pull, 1, 1e-3);
        check_close(strain[i][1] * c11 / pull, 0, 1e-4);
    }
    free(strain);
    solid_free(s);
    assert_int_equal(memory_bytes(MEMORY_SOLID), 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_patch),  cmocka_unit_test(test_momentum), cmocka_unit_test(test_energy),
        cmocka_unit_test(test_driven), cmocka_unit_test(test_traction), cmocka_unit_test(test_initial),
        cmocka_unit_test(test_stable), cmocka_unit_test(test_relaxed),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
