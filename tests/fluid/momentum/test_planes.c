/* A step whose projection takes u* from the cache, by one that ends the momentum pass first: equal to the bit. From
 * three ranks on y is cut in some of these boxes, and there is nothing to join. */
#include "tests/fluid/fluid_case.h"

#include <string.h>

enum { FIELDS = 4 };

/* Planes of which one, and three, are computed at once. */
static const int cells[][3] = {{160, 100, 9}, {64, 80, 10}};

static struct fluid_input scene(int size, int which) {
    struct fluid_input in = {.length = {1.6, 1.3, 0.1}, .density = 1.2, .viscosity = 1e-3};
    memcpy(in.n, cells[size], sizeof in.n);
    all_sides(&in, 0, FLUID_PERIODIC);
    all_sides(&in, 1, FLUID_WALL);
    all_sides(&in, 2, FLUID_PERIODIC);
    in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, 0.5};
    if (which == 0) return in;
    in.driving = (struct fluid_driving){FLUID_DRIVING_NONE, 0, 0};
    in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.5};
    in.side[0][1].type = FLUID_OUTFLOW;
    all_sides(&in, 2, FLUID_WALL);
    in.side[2][1].type = FLUID_OUTFLOW;
    return in;
}

static void step_apart(struct fluid *f, double dt) {
    for (int r = 0; r < 3; r++) {
        fluid_predict(f, r, dt);
        fluid_project(f, r, dt);
    }
    fluid_state_of(f)->t += dt;
}

static void joined_is_apart(void **state) {
    (void)state;
    for (int size = 0; size < 2; size++)
        for (int which = 0; which < 2; which++) {
            const struct fluid_input in = scene(size, which);
            struct fluid *joined = fluid_new(&in), *apart = fluid_new(&in);
            assert_int_equal(fluid_is_joined(joined), fluid_grid_of(joined)->ranks[1] == 1);
            if (par_size() <= 2) assert_true(fluid_is_joined(joined));
            stir(joined);
            stir(apart);
            for (int s = 0; s < 3; s++) {
                fluid_step(joined, 1e-3);
                step_apart(apart, 1e-3);
            }
            const struct fluid_grid *g = fluid_grid_of(joined);
            for (int c = 0; c < FIELDS; c++)
                for (int k = 0; k < g->m[2]; k++)
                    for (int j = 0; j < g->m[1]; j++)
                        assert_memory_equal(component(joined, c) + fluid_grid_at(g, 0, j, k),
                                            component(apart, c) + fluid_grid_at(g, 0, j, k),
                                            (size_t)g->m[0] * sizeof(double));
            fluid_free(joined);
            fluid_free(apart);
        }
}

FLUID_TEST_MAIN(cmocka_unit_test(joined_is_apart))
