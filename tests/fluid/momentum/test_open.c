/* Disturbed flow through sides of given pressure, at a Reynolds number of a cell of a hundred: what comes in brings no
 * disturbance; and a stream that turns back. */
#include "tests/check.h"
#include "tests/fluid/fluid_case.h"

#include <math.h>

/* Velocities that are neither smooth nor free of divergence; the first projection makes them free of it. */
static void disturb(struct fluid *f, double size) {
    const struct fluid_grid *g = fluid_grid_of(f);
    struct fluid_state *s = fluid_state_of(f);
    double *const q[3] = {s->u, s->v, s->w};
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    q[c][fluid_grid_at(g, i, j, k)] +=
                        size * sin(5.1 * (i + g->lo[0]) + 2.3 * (j + g->lo[1]) * (c + 1) + 3.7 * (k + g->lo[2]) - c);
    fluid_state_refresh(f);
}

/* The energy of the disturbance after the box has been flushed three times, over that at the start. */
static double left(struct fluid_input *in, double velocity, double size) {
    in->initial_velocity[0] = velocity;
    struct fluid *f = fluid_new(in);
    disturb(f, size);
    double share = 0, first = 0;
    const double mass = in->density * in->length[0] * in->length[1] * in->length[2];
    const double dt = 0.25 * in->length[0] / in->n[0] / (velocity + 2 * size);
    for (double t = 0; t < 3 * in->length[0] / velocity; t += dt) {
        fluid_step(f, dt);
        const double u = bulk_velocity_along(f, 0), e = fluid_measures_kinetic_energy(f) - 0.5 * mass * u * u;
        if (first == 0) first = e;
        share = e / first;
        if (!(share < 1e3)) break;
    }
    fluid_free(f);
    return share;
}

static void disturbances_leave(void **state) {
    (void)state;
    for (int size = 1; size <= 3; size += 2) {
        struct fluid_input in = {.n = {24, 12, 12}, .length = {2, 1, 1}, .density = 1, .viscosity = 1. / 12 / 100};
        in.side[0][0] = (struct fluid_side){.type = FLUID_PRESSURE};
        in.side[0][1] = (struct fluid_side){.type = FLUID_PRESSURE};
        const double share = left(&in, 1, 0.2 * size);
        print_message("disturbance %.1f of the stream: %.3g of its energy is left\n", 0.2 * size, share);
        check_between(share, 0, 0.1);
    }
}

/* A uniform stream u < 0 that comes back through a side that drains slows down by its dynamic pressure, u' = u^2/(2L),
 * so u = u_0/(1 - u_0 t/(2L)); through one that does not drain it goes on. Along each axis, to either side. */
static void turning_back_meets_the_dynamic_pressure(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            for (int drains = 0; drains < 2; drains++) {
                struct fluid_input in = {.n = {6, 6, 6}, .length = {2, 2, 2}, .density = 3, .viscosity = 0.01};
                in.side[d][side] = (struct fluid_side){.type = FLUID_PRESSURE};
                in.side[d][!side] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = drains * 1e-12};
                in.initial_velocity[d] = side ? -1 : 1;
                struct fluid *f = fluid_new(&in);
                for (int n = 0; n < 200; n++) fluid_step(f, 0.01);
                const double u = bulk_velocity_along(f, d) * in.initial_velocity[d];
                check_close(u, drains ? 1 / (1 + 2 / 4.) : 1, drains ? 1e-6 : 1e-12);
                fluid_free(f);
            }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(disturbances_leave),
                                       cmocka_unit_test(turning_back_meets_the_dynamic_pressure)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
