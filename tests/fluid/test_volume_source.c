/* Volume that enters the flow at points: the divergence of their cells, on any rank and in any domain that holds them.
 */
#include "tests/fluid/fluid_case.h"

#include "tests/check.h"

static struct fluid *box(int walls) {
    struct fluid_input in = {.n = {8, 12, 10}, .length = {0.8, 1.2, 1}, .density = 2, .viscosity = 0.01};
    for (int d = 0; d < 3 && walls; d++) in.side[d][0].type = in.side[d][1].type = FLUID_WALL;
    in.initial_velocity[0] = walls ? 0 : 0.5;
    return fluid_new(&in);
}

/* The divergence in the cell of a point, on the rank that holds it; 0 elsewhere. */
static double divergence_at(struct fluid *f, const double x[3]) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const struct fluid_state *s = fluid_state_of(f);
    if (fluid_grid_rank_of(g, x) != par_rank()) return 0;
    const size_t at = fluid_grid_at(g, (int)(x[0] / g->d[0]) - g->lo[0], (int)(x[1] / g->d[1]) - g->lo[1],
                                    (int)(x[2] / g->d[2]) - g->lo[2]);
    return (s->u[at] - s->u[at - 1]) / g->d[0] + (s->v[at] - s->v[at - (size_t)g->row]) / g->d[1] +
           (s->w[at] - s->w[at - (size_t)g->plane]) / g->d[2];
}

/* Every rank gives a part of a sink and of two sources, one of which stands a period farther. */
static void rates(void **state) {
    (void)state;
    const double volume = 0.1 * 0.1 * 0.1, part = 1.0 / par_size();
    for (int walls = 0; walls < 2; walls++) {
        struct fluid *f = box(walls);
        const double far = walls ? 0 : 1.2;
        const double x[3][3] = {{0.25, 0.31, 0.55}, {0.45, 0.62 + far, 0.55}, {0.45, 0.95, 0.15}};
        const double near[3] = {0.45, 0.62, 0.55}, rate[3] = {-3e-4 * part, 2e-4 * part, 1e-4 * part};
        fluid_volume_source_set(f, 3, x, rate);
        for (int k = 0; k < 3; k++) fluid_step(f, 0.01);
        check_relative(par_sum(divergence_at(f, x[0])), -3e-4 / volume, 1e-11);
        check_relative(par_sum(divergence_at(f, near)), 2e-4 / volume, 1e-11);
        check_relative(par_sum(divergence_at(f, x[2])), 1e-4 / volume, 1e-11);
        check_close(fluid_measures_of(f).divergence_max, 0, 1e-12);
        fluid_volume_source_clear(f);
        fluid_step(f, 0.01);
        check_close(par_sum(divergence_at(f, x[0])), 0, 1e-12);
        check_close(fluid_measures_of(f).divergence_max, 0, 1e-12);
        fluid_free(f);
    }
}

/* Next to a side the low faces follow from div u = 0. */
static void places(void **state) {
    (void)state;
    struct fluid *f = box(1);
    assert_int_equal(fluid_volume_source_holds(f, (const double[3]){0.15, 0.15, 0.85}), 1);
    assert_int_equal(fluid_volume_source_holds(f, (const double[3]){0.05, 0.15, 0.85}), 0);
    assert_int_equal(fluid_volume_source_holds(f, (const double[3]){0.15, 0.15, 0.95}), 0);
    assert_int_equal(fluid_volume_source_holds(f, (const double[3]){0.15, -0.15, 0.85}), 0);
    fluid_free(f);
    f = box(0);
    assert_int_equal(fluid_volume_source_holds(f, (const double[3]){-0.05, 9, 0.95}), 1);
    fluid_free(f);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(rates), cmocka_unit_test(places)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
