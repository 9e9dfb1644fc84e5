/* The couple on the box is the rate of change of the fluid's angular momentum, with every type of side. */
#include "fluid/scheme.h"
#include "tests/fluid/fluid_case.h"

#include <stdio.h>

static void set_sides(struct fluid_input *in, int d, enum fluid_side_type low, enum fluid_side_type high) {
    in->side[d][0].type = low;
    in->side[d][1].type = high;
    if (low == FLUID_WALL) in->side[d][0].velocity[(d + 1) % 3] = 0.7;
    if (high == FLUID_WALL) in->side[d][1].velocity[(d + 2) % 3] = -0.4;
    if (low == FLUID_INFLOW) in->side[d][0].bulk_velocity = 0.5;
    if (high == FLUID_INFLOW) in->side[d][1].bulk_velocity = 0.5;
    if (low == FLUID_PRESSURE) in->side[d][0].pressure = 2;
}

/* Relative to the largest part of the couple or to what one face's momentum does. */
static void check_step(struct fluid_input *in, const char *what) {
    struct fluid *f = fluid_new(in);
    double before[3], after[3], force[3], couple[3], scale = 0;
    const double dt = 2e-3;
    stir(f);
    fluid_step(f, dt);
    fluid_measures_momentum(f, NULL, before);
    fluid_box_force_begin(f);
    fluid_step(f, dt);
    fluid_box_force_end(f, force);
    assert_true(fluid_box_couple_end(f, couple));
    fluid_measures_momentum(f, NULL, after);
    for (int c = 0; c < 3; c++) scale = fmax(scale, fabs(after[c]) / dt);
    for (int c = 0; c < 3; c++) {
        const double rate = (after[c] - before[c]) / dt;
        if (fabs(rate - couple[c]) > 1e-11 * scale) print_message("%s, %d: %g, couple %g\n", what, c, rate, couple[c]);
        check_close(rate, couple[c], 1e-11 * scale);
    }
    check_above(fabs(couple[0]) + fabs(couple[1]) + fabs(couple[2]), 1e-4 * scale);
    fluid_free(f);
}

static void the_couple_changes_the_angular_momentum(void **state) {
    (void)state;
    static const enum fluid_side_type pair[][2] = {
        {FLUID_WALL, FLUID_WALL},        {FLUID_SLIP, FLUID_SLIP},      {FLUID_PERIODIC, FLUID_PERIODIC},
        {FLUID_INFLOW, FLUID_OUTFLOW},   {FLUID_OUTFLOW, FLUID_INFLOW}, {FLUID_PRESSURE, FLUID_PRESSURE},
        {FLUID_PRESSURE, FLUID_OUTFLOW}, {FLUID_WALL, FLUID_PRESSURE},
    };
    static const char *const name[] = {"wall",    "slip",     "periodic",      "in, out",
                                       "out, in", "pressure", "pressure, out", "wall, pressure"};
    for (int d = 0; d < 3; d++)
        for (int kind = 0; kind < (int)(sizeof pair / sizeof *pair); kind++)
            for (int other = 0; other < 3; other++) {
                struct fluid_input in = {.n = {10, 12, 11}, .length = {1, 1.5, 2}, .density = 3, .viscosity = 0.02};
                for (int c = 0; c < 3; c++) set_sides(&in, c, pair[other][0], pair[other][1]);
                set_sides(&in, d, pair[kind][0], pair[kind][1]);
                in.body_force[0] = 0.3;
                in.body_force[2] = -0.2;
                if (in.side[1][0].type == FLUID_PERIODIC)
                    in.driving = (struct fluid_driving){.type = FLUID_DRIVING_GRADIENT, .direction = 1, .value = 0.5};
                char what[64];
                snprintf(what, sizeof what, "%s along %c, %s", name[kind], "xyz"[d], name[other]);
                check_step(&in, what);
            }
}

FLUID_TEST_MAIN(cmocka_unit_test(the_couple_changes_the_angular_momentum))
