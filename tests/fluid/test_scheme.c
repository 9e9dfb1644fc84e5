/* Adams and Bashforth's scheme (fluid/scheme.h): order in time, changing steps, balance of momentum, stable step. */
#include "fluid/scheme.h"
#include "tests/check.h"
#include "tests/fluid/fluid_case.h"
#include "tests/fluid/sides.h"
#include "tests/fluid/vortices.h"

#include <complex.h>
#include <stdlib.h>

/* The velocity at t = 1. uneven: every other step is twice as long as the one before. */
static void vortices(enum fluid_integrator integrator, int steps, int uneven, double *u) {
    struct fluid *f = vortices_new((struct fluid_input){.keeps_rate = 1});
    fluid_scheme_set(f, integrator);
    for (int s = 0; s < steps; s++) fluid_step(f, (uneven ? (s % 2 ? 4. : 2.) / 3 : 1.) / steps);
    check_below(fluid_measures_of(f).divergence_max, 1e-12);
    vortices_gather(f, u);
    fluid_free(f);
}

/* Second order, with steps of one length and of two in turn. */
static void order_in_time(void **state) {
    (void)state;
    double *fine = malloc(VORTICES_VALUES * sizeof *fine), *u = malloc(VORTICES_VALUES * sizeof *u), error[2][3];
    vortices(FLUID_RK3, 80, 0, fine);
    for (int uneven = 0; uneven < 2; uneven++)
        for (int i = 0; i < 3; i++) {
            vortices(FLUID_AB2, 20 << i, uneven, u);
            error[uneven][i] = vortices_distance(u, fine);
        }
    for (int uneven = 0; uneven < 2; uneven++)
        for (int i = 0; i < 2; i++) {
            const double order = log2(error[uneven][i] / error[uneven][i + 1]);
            print_message("order: %.2f (error %.2g m/s)\n", order, error[uneven][i]);
            check_between(order, 1.8, 2.3);
        }
    free(fine);
    free(u);
}

/* What a step reads of the one before is R and its length: a step from the same state is the same to the bit, and with
 * RK3 in between the next one starts again. */
static void begins_anew(void **state) {
    (void)state;
    double *u[2] = {malloc(VORTICES_VALUES * sizeof(double)), malloc(VORTICES_VALUES * sizeof(double))};
    const struct fluid_input in = {.keeps_rate = 1};
    struct fluid *f = vortices_new(in), *euler = vortices_new(in);
    fluid_scheme_set(f, FLUID_AB2);
    assert_int_equal(fluid_scheme_stages(f), 1);
    fluid_step(f, 0.05);
    check_equal(fluid_state_of(f)->rate_dt, 0.05);
    fluid_scheme_set(f, FLUID_AB2); /* of a stage of the run that changes nothing */
    check_equal(fluid_state_of(f)->rate_dt, 0.05);
    fluid_scheme_set(f, FLUID_RK3);
    check_equal(fluid_state_of(f)->rate_dt, 0);
    fluid_scheme_set(f, FLUID_AB2);
    for (int c = 0; c < 4; c++) memcpy(component(euler, c), component(f, c), fluid_grid_of(f)->size * sizeof(double));
    fluid_state_of(euler)->t = fluid_state_of(f)->t;
    fluid_scheme_set(euler, FLUID_AB2);
    struct fluid *const both[2] = {f, euler};
    for (int k = 0; k < 2; k++) {
        for (int s = 0; s < 3; s++) fluid_step(both[k], 0.05);
        vortices_gather(both[k], u[k]);
        fluid_free(both[k]);
    }
    assert_memory_equal(u[0], u[1], VORTICES_VALUES * sizeof(double));
    for (int k = 0; k < 2; k++) free(u[k]);
}

/* The force on the box, with R of the step before, is the change of momentum, to round-off, whatever the sides are. */
static void momentum_is_balanced(void **state) {
    (void)state;
    for (int w = 0; w < SIDES; w++)
        for (int projection = 0; projection < 2; projection++) {
            struct fluid_input in = sides_of(w);
            in.projection = (enum fluid_projection)projection;
            in.keeps_rate = 1;
            struct fluid *f = fluid_new(&in);
            fluid_scheme_set(f, FLUID_AB2);
            stir(f);
            for (int s = 0; s < 6; s++) {
                const double dt = s < 4 ? 0.02 : 0.01;
                double before[3], after[3], force[3];
                fluid_measures_momentum(f, before, NULL);
                fluid_box_force_begin(f);
                fluid_step(f, dt);
                fluid_box_force_end(f, force);
                fluid_measures_momentum(f, after, NULL);
                check_below(fluid_measures_of(f).divergence_max, 1e-11);
                for (int c = 0; c < 3; c++) check_close((after[c] - before[c]) / dt, force[c], 1e-11);
            }
            fluid_free(f);
        }
}

/* The larger of the two factors by which a step multiplies a mode of the rate z = lambda dt. */
static double growth(double complex z) {
    const double complex b = 1 + 1.5 * z, root = csqrt(b * b - 2 * z);
    return fmax(cabs(0.5 * (b + root)), cabs(0.5 * (b - root)));
}

/* At the limits every mode of central differences decays, whichever directions the flow goes along and the grid is fine
 * in; at twice the viscous limit one grows. */
static void limits_are_stable(void **state) {
    (void)state;
    enum { ANGLES = 24 };
    for (int kind = 0; kind < 64; kind++) {
        struct fluid_input in = {.n = {8, 8, 8}, .density = 1, .viscosity = pow(10, -4 + kind % 4), .keeps_rate = 1};
        double velocity[3], rate = 0;
        for (int d = 0; d < 3; d++) {
            in.length[d] = 8 * (1 + (kind >> (2 + d) & 1));
            velocity[d] = d == 0 ? 1 : kind >> (4 + d) & 1 ? 0.7 : 0;
        }
        struct fluid *f = fluid_new(&in);
        const struct fluid_grid *g = fluid_grid_of(f);
        fluid_scheme_set(f, FLUID_AB2);
        for (int d = 0; d < 3; d++) rate += velocity[d] / g->d[d];
        const double dt = fluid_limits_of(f, rate).step;
        double most = 0, viscous = 0;
        for (int a = 0; a < ANGLES * ANGLES * ANGLES; a++) {
            const int at[3] = {a % ANGLES, a / ANGLES % ANGLES, a / (ANGLES * ANGLES)};
            double complex z = 0;
            for (int d = 0; d < 3; d++) {
                const double angle = M_PI * (at[d] + 1) / ANGLES;
                z -= dt * 4 * in.viscosity / (g->d[d] * g->d[d]) * pow(sin(angle / 2), 2);
                z += I * dt * velocity[d] / g->d[d] * sin(angle);
            }
            most = fmax(most, growth(z));
        }
        check_below(most, 1 + 1e-12);
        for (int d = 0; d < 3; d++) viscous -= 4 * in.viscosity / (g->d[d] * g->d[d]);
        assert_true(growth(2 * fluid_limits_of(f, 0).viscous * viscous) > 1);
        fluid_free(f);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(order_in_time), cmocka_unit_test(begins_anew), cmocka_unit_test(momentum_is_balanced),
                cmocka_unit_test(limits_are_stable))
