/* The box's force equals the change of its momentum; stability limits; detection of NaN. */
#include "base/step_status.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

static struct fluid_input mixed(int sides) {
    struct fluid_input in = {.n = {12, 10, 9}, .length = {1.2, 1, 0.9}, .density = 1.3, .viscosity = 0.02};
    in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.7};
    in.side[0][1].type = FLUID_OUTFLOW;
    all_sides(&in, 1, FLUID_WALL);
    in.side[1][1].velocity[2] = 0.4;
    all_sides(&in, 2, FLUID_SLIP);
    in.initial_velocity[0] = 0.7;
    for (int d = 0; d < 3; d++) in.body_force[d] = 0.1 * (d + 1);
    if (sides == 1) {
        in.side[0][0] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 0.4};
        in.side[0][1] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = -0.2};
        all_sides(&in, 2, FLUID_PERIODIC);
        in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, 2, 0.5};
    }
    if (sides == 2) {
        in.side[1][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_UNIFORM, .bulk_velocity = 0.2};
        in.side[2][0].type = FLUID_OUTFLOW;
    }
    return in;
}

/* d/dt of the momentum is the force on the box: over one short step its mean of both ends, with an error that falls
 * with the step. */
static void box_force_changes_the_momentum(void **state) {
    (void)state;
    for (int sides = 0; sides < 3; sides++) {
        if (check_skips(sides, 1)) continue; /* in a debug build the first and the last */
        double error[2] = {0, 0};
        for (int r = 0; r < 2; r++) {
            const struct fluid_input in = mixed(sides);
            const double dt = 2e-3 / (1 << r);
            struct fluid *f = fluid_new(&in);
            double force[2][3], momentum[2][3];
            for (int i = 0; i < 30 << r; i++) fluid_step(f, dt);
            for (int i = 0; i < 2; i++) {
                fluid_box_force(f, force[i]);
                fluid_measures_momentum(f, momentum[i], NULL);
                if (i == 0) fluid_step(f, dt);
            }
            for (int c = 0; c < 3; c++) {
                const double mean = 0.5 * (force[0][c] + force[1][c]);
                error[r] = check_worst(error[r], ((momentum[1][c] - momentum[0][c]) / dt - mean));
            }
            fluid_free(f);
        }
        /* the body force alone is 0.14 to 0.42 N; the pressure is that of the last stage, early by a part of the step
         */
        check_below(error[1], 1e-3);
        if (!(error[0] > 1.8 * error[1])) fail_msg("sides %d: errors %g %g", sides, error[0], error[1]);
    }
}

/* In steady flow the force is zero. */
static void box_force_vanishes_when_steady(void **state) {
    (void)state;
    for (int sides = 0; sides < 2; sides++) {
        struct fluid_input in = mixed(sides);
        in.viscosity = 0.1;
        struct fluid *f = fluid_new(&in);
        double force[3];
        const double dt = 0.8 * fluid_limits_stable_step(f).step;
        for (double t = 0; t < 25; t += dt) fluid_step(f, dt);
        fluid_box_force(f, force);
        for (int c = 0; c < 3; c++) check_close(force[c], 0, 1e-10);
        fluid_free(f);
    }
}

static void limits(void **state) {
    (void)state;
    struct fluid_input in = {.n = {128, 64, 64},
                             .length = {0.2, 0.1, 0.1},
                             .density = 1000,
                             .viscosity = 1e-3,
                             .initial_velocity = {0.1, 0, 0}};
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    for (int d = 0; d < 3; d++) in.n[d] /= 4;
    struct fluid *f = fluid_new(&in);
    const struct fluid_limits l = fluid_limits_stable_step(f);
    const double cell = 0.2 / 32;
    check_close(l.viscous, 1.65 * cell * cell / (12 * 1e-3), 1e-15);
    check_close(l.convective, sqrt(3) * cell / 0.1, 1e-12);
    check_close(l.convective * fluid_measures_of(f).convection_rate, sqrt(3), 1e-12);
    check_close(l.step, fmin(l.viscous, l.convective), 0);
    fluid_free(f);
}

/* A NaN is found by the rank that has it, with its position and name; so is a speed beyond reason; a sound state
 * passes. */
static void check_finds_a_nan(void **state) {
    (void)state;
    const struct fluid_input in = mixed(0);
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    fluid_step(f, 1e-3);
    assert_false(fluid_limits_check(f).failed);
    for (int c = 0; c < 4; c++)
        for (int huge = 0; huge < 2; huge++) {
            if (c == 3 && huge) continue;
            double *q = component(f, c) + fluid_grid_at(g, 5, 1, 1), keep = *q;
            if (par_rank() == par_size() - 1) *q = huge ? 1e9 : NAN;
            struct step_status s = fluid_limits_check(f);
            assert_int_equal(s.failed, par_rank() == par_size() - 1);
            assert_true(step_status_agree(&s));
            assert_int_equal(s.rank, par_size() - 1);
            assert_int_equal(s.seen_in, STEP_STATUS_FLUID);
            assert_string_equal(s.field, c == 0 ? "u" : c == 1 ? "v" : c == 2 ? "w" : "p");
            check_close(s.x[0], c == 0 ? 0.6 : 0.55, 1e-12);
            *q = keep;
        }
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(box_force_changes_the_momentum), cmocka_unit_test(box_force_vanishes_when_steady),
                cmocka_unit_test(limits), cmocka_unit_test(check_finds_a_nan))
