/* The loss of kinetic energy equals fluid_dissipation: convection and pressure do no work. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

static void fill(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    component(f, c)[fluid_grid_at(g, i, j, k)] = random_at(i + g->lo[0], j + g->lo[1], k + g->lo[2], c);
    fluid_state_refresh(f);
}

/* Over one short step, against the mean of the rates before and after: the difference is proportional to the square of
 * the step. */
static void balances(enum fluid_side_type x, enum fluid_side_type y, enum fluid_side_type z) {
    struct fluid_input in = {.n = {6, 8, 10}, .length = {1, 2, 1.5}, .density = 3, .viscosity = 0.02};
    const enum fluid_side_type type[3] = {x, y, z};
    for (int d = 0; d < 3; d++) all_sides(&in, d, type[d]);
    struct fluid *f = fluid_new(&in);
    fill(f);
    const double dt = 1e-5;
    fluid_step(f, dt); /* makes it divergence-free */
    const double before = fluid_measures_kinetic_energy(f), rate = fluid_measures_of(f).dissipation;
    fluid_step(f, dt);
    const double loss = (before - fluid_measures_kinetic_energy(f)) / dt,
                 mean = 0.5 * (rate + fluid_measures_of(f).dissipation);
    check_above(mean, 0.01);
    check_close(loss, mean, 1e-6 * mean);
    fluid_free(f);
}

static void between_all_kinds_of_sides(void **state) {
    (void)state;
    balances(FLUID_PERIODIC, FLUID_PERIODIC, FLUID_PERIODIC);
    balances(FLUID_WALL, FLUID_WALL, FLUID_WALL);
    balances(FLUID_PERIODIC, FLUID_WALL, FLUID_SLIP);
    balances(FLUID_SLIP, FLUID_PERIODIC, FLUID_WALL);
}

/* A uniform shear between a wall at rest and a moving one: rho nu (U/h)^2 V, and no more for the half cells beside the
 * walls. */
static void of_a_shear(void **state) {
    (void)state;
    for (int across = 0; across < 3; across++) {
        const int stream = (across + 1) % 3;
        struct fluid_input in = {.n = {6, 6, 6}, .length = {1.5, 1.5, 1.5}, .density = 2, .viscosity = 0.5};
        for (int d = 0; d < 3; d++) all_sides(&in, d, d == across ? FLUID_WALL : FLUID_PERIODIC);
        in.side[across][1].velocity[stream] = 3;
        struct fluid *f = fluid_new(&in);
        const struct fluid_grid *g = fluid_grid_of(f);
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    component(f, stream)[fluid_grid_at(g, i, j, k)] =
                        3 * ((int[]){i, j, k}[across] + g->lo[across] + 0.5) / 6;
        fluid_state_refresh(f);
        const double expected = 2 * 0.5 * pow(3 / 1.5, 2) * pow(1.5, 3);
        check_close(fluid_measures_of(f).dissipation, expected, 1e-12 * expected);
        fluid_free(f);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(between_all_kinds_of_sides), cmocka_unit_test(of_a_shear))
