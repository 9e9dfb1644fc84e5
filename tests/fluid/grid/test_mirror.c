/* The continuation of u* beyond a side equals the ghost cells that the boundary conditions fill. */
#include "tests/fluid/fluid_case.h"

/* The first value of component c beyond the side, for the cells at `at` of the other two directions. */
static void compare(struct fluid *f, int c, int d, int side, const int others[2]) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const double *q = fluid_predicted(f)[c];
    const struct fluid_mirror m = fluid_mirror_predicted(f, c, d, side);
    const int a = d == 0, b = d == 2 ? 1 : 2, on_face = c == d;
    int at[3];
    at[a] = others[0];
    at[b] = others[1];
    /* indices of the ghost, the face and the mirrored value: a face's mirror is two faces inward */
    const int face = side ? g->m[d] - 1 : -1;
    const int ghost = side ? g->m[d] : on_face ? -2 : -1;
    const int inner = !on_face ? (side ? g->m[d] - 1 : 0) : side ? g->m[d] - 2 : 0;
    double value[3];
    const int place[3] = {ghost, face, inner};
    for (int k = 0; k < 3; k++) {
        at[d] = place[k];
        value[k] = q[fluid_grid_at(g, at[0], at[1], at[2])];
    }
    check_close(value[0], (m.face != 0 ? m.face * value[1] : 0) + m.inner * value[2] + m.constant, 1e-13);
}

/* All types of sides that need no flow to balance, and an inflow with an outflow. */
static void the_mirror_is_the_ghost(void **state) {
    (void)state;
    struct fluid_side general = {.type = FLUID_GENERAL, .velocity = {0.3, -0.2, 0.7}};
    const struct fluid_side wall = {.type = FLUID_WALL, .velocity = {0.5, 0.25, -0.125}};
    for (int d = 0; d < 3; d++)
        for (int kind = 0; kind < 6; kind++) {
            struct fluid_input in = {
                .n = {6, 5, 7}, .length = {0.6, 0.5, 1.4}, .density = 2, .viscosity = 0.1, .immersed = 1};
            for (int c = 0; c < 3; c++) all_sides(&in, c, c == d ? FLUID_SLIP : FLUID_PERIODIC);
            for (int side = 0; side < 2; side++) {
                if (kind == 1) in.side[d][side] = wall;
                if (kind == 1) in.side[d][side].velocity[d] = 0;
                if (kind == 2 || kind == 3) { /* the pressure given or not; the velocity's gradients */
                    for (int c = 0; c < 3; c++)
                        general.condition[c] = c == d && kind == 2 ? FLUID_DIRICHLET : FLUID_NEUMANN;
                    general.condition[3] = kind == 2 ? FLUID_NEUMANN : FLUID_DIRICHLET;
                    in.side[d][side] = general;
                    in.side[d][side].velocity[d] = kind == 2 ? 0 : 0.4;
                }
                if (kind == 4) in.side[d][side] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 3};
            }
            if (kind == 5) {
                in.side[d][0] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = 1};
                in.side[d][1] = (struct fluid_side){.type = FLUID_OUTFLOW};
            }
            struct fluid *f = fluid_new(&in);
            const struct fluid_grid *g = fluid_grid_of(f);
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < g->m[2]; k++)
                    for (int j = 0; j < g->m[1]; j++)
                        for (int i = 0; i < g->m[0]; i++)
                            fluid_predicted(f)[c][fluid_grid_at(g, i, j, k)] =
                                random_at(c, g->lo[0] + i, g->lo[1] + j, g->lo[2] + k);
            fluid_predicted_refresh(f, 2);
            for (int c = 0; c < 3; c++)
                for (int side = 0; side < 2; side++) {
                    const int at[2] = {2, 3};
                    compare(f, c, d, side, at);
                }
            fluid_free(f);
        }
}

/* Across periodic sides the value is the other side's: nothing is mirrored. */
static void periodic_sides_have_no_mirror(void **state) {
    (void)state;
    struct fluid_input in = {.n = {4, 4, 4}, .length = {1, 1, 1}, .density = 1, .viscosity = 1};
    struct fluid *f = fluid_new(&in);
    for (int d = 0; d < 3; d++)
        for (int c = 0; c < 3; c++) {
            const struct fluid_mirror m = fluid_mirror_predicted(f, c, d, 1);
            check_equal(m.inner, 1);
            check_equal(m.face, 0);
            check_equal(m.constant, 0);
        }
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(the_mirror_is_the_ghost), cmocka_unit_test(periodic_sides_have_no_mirror))
