/* Flows with sides and driving of each kind, for tests of the balance of momentum. */
#pragma once
#include "tests/fluid/fluid_case.h"

enum { SIDES = 4 };

static inline struct fluid_input sides_of(int which) {
    struct fluid_input in = {.n = {18, 14, 16}, .length = {1.8, 1.4, 1.6}, .density = 1.2, .viscosity = 0.01};
    all_sides(&in, 0, FLUID_PERIODIC);
    all_sides(&in, 1, FLUID_WALL);
    all_sides(&in, 2, FLUID_PERIODIC);
    in.initial_velocity[0] = 0.5;
    in.body_force[1] = 0.3;
    if (which == 0) in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, 0.5};
    if (which == 1) {
        in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, 0, 0.7};
        in.driving_frequency = 3;
    }
    if (which >= 2) {
        in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.5};
        in.side[0][1].type = FLUID_OUTFLOW;
    }
    if (which == 3) {
        in.side[1][0] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 0.2};
        in.side[2][1].type = FLUID_OUTFLOW;
        in.side[2][0].type = FLUID_SLIP;
    }
    return in;
}
