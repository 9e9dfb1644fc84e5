/* A velocity field linear in x, y and z is interpolated exactly, by one rank. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

static double linear(int q, const double x[3]) { return q + 1 + 2 * x[0] - 3 * x[1] + (q + 0.5) * x[2]; }

static void linear_is_exact(void **state) {
    (void)state;
    struct fluid_input in = {.n = {5, 7, 9}, .length = {1, 1.4, 2.7}, .density = 1, .viscosity = 0.1};
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_WALL);
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    for (int q = 0; q < 4; q++)
        for (int k = -1; k <= g->m[2]; k++)
            for (int j = -1; j <= g->m[1]; j++)
                for (int i = -1; i <= g->m[0]; i++) {
                    const int at[3] = {i, j, k};
                    double x[3];
                    for (int d = 0; d < 3; d++) x[d] = (at[d] + g->lo[d] + (d == q ? 1.0 : 0.5)) * g->d[d];
                    component(f, q)[fluid_grid_at(g, i, j, k)] = linear(q, x);
                }
    for (int n = 0; n < 200; n++) {
        double x[3], value[4], sum[4];
        for (int d = 0; d < 3; d++) { /* sides and corners too */
            const double part = 1.2 * random_at(n, d, 7, 3) + 0.5;
            x[d] = in.length[d] * fmin(fmax(part, 0), 1);
        }
        fluid_value_at(f, x, value);
        memcpy(sum, value, sizeof sum);
        par_sum_array(sum, 4);
        for (int q = 0; q < 4; q++) {
            check_close(sum[q], linear(q, x), 1e-12);
            assert_true(value[q] == 0 || value[q] == sum[q]);
        }
    }
    fluid_free(f);
}

/* In periodic directions a point on the far end is the one on the near end. */
static void periodic_is_wrapped(void **state) {
    (void)state;
    struct fluid_input in = {.n = {6, 6, 6}, .length = {1, 1, 1}, .density = 1, .viscosity = 0.1};
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    in.vortices = (struct fluid_vortices){1, {1, 1, 1}};
    struct fluid *f = fluid_new(&in);
    double low[4], high[4];
    fluid_value_at(f, (double[3]){0, 0.3, 0}, low);
    fluid_value_at(f, (double[3]){1, 0.3, 1}, high);
    par_sum_array(low, 4);
    par_sum_array(high, 4);
    check_above(fabs(low[1]), 0.5);
    for (int q = 0; q < 4; q++) check_close(low[q], high[q], 1e-14);
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(linear_is_exact), cmocka_unit_test(periodic_is_wrapped))
