/* One projection a step (FLUID_LAST_STAGE): order in time, divergence, balance of momentum. */
#include "tests/check.h"
#include "tests/fluid/fluid_case.h"
#include "tests/fluid/sides.h"
#include "tests/fluid/vortices.h"

#include <stdlib.h>

/* The velocity at t = 1. */
static void vortices(enum fluid_projection projection, int steps, double *u) {
    struct fluid *f = vortices_new((struct fluid_input){.projection = projection});
    for (int s = 0; s < steps; s++) fluid_step(f, 1.0 / steps);
    check_below(fluid_measures_of(f).divergence_max, 1e-12);
    vortices_gather(f, u);
    fluid_free(f);
}

/* Projected after each stage the velocity is of third order in time, projected once of second. */
static void orders_in_time(void **state) {
    (void)state;
    double *fine = malloc(VORTICES_VALUES * sizeof *fine), *u = malloc(VORTICES_VALUES * sizeof *u), error[2][3];
    vortices(FLUID_EACH_STAGE, 160, fine);
    for (int p = 0; p < 2; p++)
        for (int i = 0; i < 3; i++) {
            vortices((enum fluid_projection)p, 10 << i, u);
            error[p][i] = vortices_distance(u, fine);
        }
    for (int i = 0; i < 2; i++) {
        const double each = log2(error[0][i] / error[0][i + 1]), last = log2(error[1][i] / error[1][i + 1]);
        print_message("order: each stage %.2f, last stage %.2f (error %.2g, %.2g m/s)\n", each, last, error[0][i],
                      error[1][i]);
        check_between(each, 2.7, 3.3);
        check_between(last, 1.8, 2.3);
    }
    free(fine);
    free(u);
}

/* The force on the box, summed stage by stage with the velocities that are not free of divergence, is the change of
 * momentum, to round-off. The driving of the step is what its mean says. */
static void momentum_is_balanced(void **state) {
    (void)state;
    for (int w = 0; w < SIDES; w++) {
        struct fluid_input in = sides_of(w);
        in.projection = FLUID_LAST_STAGE;
        struct fluid *f = fluid_new(&in);
        const double dt = 0.02;
        stir(f);
        for (int s = 0; s < 5; s++) {
            double before[3], after[3], force[3];
            fluid_measures_momentum(f, before, NULL);
            fluid_box_force_begin(f);
            fluid_step(f, dt);
            fluid_box_force_end(f, force);
            fluid_measures_momentum(f, after, NULL);
            check_below(fluid_measures_of(f).divergence_max, 1e-11);
            for (int c = 0; c < 3; c++) check_close((after[c] - before[c]) / dt, force[c], 1e-11);
        }
        if (w == 0) check_close(fluid_state_of(f)->driven, fluid_state_of(f)->driving, 1e-14);
        if (w == 0) check_close(bulk_velocity_along(f, 0), 0.5, 1e-13);
        fluid_free(f);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(orders_in_time), cmocka_unit_test(momentum_is_balanced))
