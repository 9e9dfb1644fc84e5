/* Lid-driven cavity at Re = 100: extrema on the centrelines against Marchi et al. (2009): u -0.2140417, v 0.1795728 and
 * -0.2538030. With 32 cells the error of a second-order scheme is four times that allowed for 64 (0.7 %). */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

enum { N = 32 };

/* Quadratic through the extreme value and its neighbours. */
static double extremum(const double *line, int sign) {
    int at = 1;
    for (int i = 1; i < N - 1; i++)
        if (sign * line[i] > sign * line[at]) at = i;
    const double slope = 0.5 * (line[at + 1] - line[at - 1]), bend = line[at + 1] - 2 * line[at] + line[at - 1];
    return line[at] - 0.5 * slope * slope / bend;
}

static void reynolds_100(void **state) {
    (void)state;
    struct fluid_input in = {.n = {N, N, 4}, .length = {1, 1, 0.125}, .density = 1, .viscosity = 0.01};
    for (int d = 0; d < 2; d++) all_sides(&in, d, FLUID_WALL);
    all_sides(&in, 2, FLUID_PERIODIC);
    in.side[1][1].velocity[0] = 1;
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    const double dt = 0.9 * fluid_limits_stable_step(f).viscous;
    for (double t = 0; t < 25; t += dt) {
        fluid_step(f, dt);
        if (t < 20 * dt) check_below(fluid_measures_of(f).divergence_max, 1e-12);
    }
    double u[N] = {0}, v[N] = {0};
    for (int j = 0; j < g->m[1] && g->lo[2] == 0; j++) {
        u[j + g->lo[1]] = fluid_state_of(f)->u[fluid_grid_at(g, N / 2 - 1, j, 0)];
        if (j + g->lo[1] == N / 2 - 1)
            for (int i = 0; i < N; i++) v[i] = fluid_state_of(f)->v[fluid_grid_at(g, i, j, 0)];
    }
    par_sum_array(u, N);
    par_sum_array(v, N);
    check_close(extremum(u, -1), -0.2140417, 0.028 * 0.2140417);
    check_close(extremum(v, 1), 0.1795728, 0.028 * 0.1795728);
    check_close(extremum(v, -1), -0.2538030, 0.028 * 0.2538030);
    if (par_rank() == 0)
        print_message("u min %.6f, v max %.6f, v min %.6f\n", extremum(u, -1), extremum(v, 1), extremum(v, -1));
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(reynolds_100))
