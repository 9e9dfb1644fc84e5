/* Initial Taylor-Green vortices: their values on the faces, and zero discrete divergence. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

static struct fluid_input box(const int n[3], const double length[3]) {
    struct fluid_input in = {.density = 2, .viscosity = 0.1};
    memcpy(in.n, n, sizeof in.n);
    memcpy(in.length, length, sizeof in.length);
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    return in;
}

/* Largest distance from V sin X cos Y cos Z, -h V cos X sin Y cos Z and the mean, X ... along a, b and, in space, the
 * third. */
static double distance(struct fluid *f, int a, int b, int space, double h, const double mean[3]) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const double v = fluid_input_of(f)->vortices.velocity;
    double worst = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int at[3] = {i, j, k}, z = 3 - a - b;
                    double x[3];
                    for (int d = 0; d < 3; d++) x[d] = 2 * M_PI * (at[d] + g->lo[d] + (d == c ? 1.0 : 0.5)) / g->n[d];
                    const double third = space ? cos(x[z]) : 1;
                    const double expected = c == a   ? v * sin(x[a]) * cos(x[b]) * third
                                            : c == b ? -h * v * cos(x[a]) * sin(x[b]) * third
                                                     : 0;
                    worst = check_worst(worst, component(f, c)[fluid_grid_at(g, i, j, k)] - expected - mean[c]);
                }
    return par_max(worst);
}

static void in_every_plane_and_in_space(void **state) {
    (void)state;
    static const int along[4][3] = {{1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const double mean[3] = {0.5, -0.25, 0.125}, l = 2 * M_PI;
    for (int p = 0; p < 4; p++) {
        struct fluid_input in = box((int[3]){12, 12, 12}, (double[3]){l, l, l});
        in.vortices.velocity = 1.5;
        memcpy(in.vortices.along, along[p], sizeof along[p]);
        memcpy(in.initial_velocity, mean, sizeof mean);
        struct fluid *f = fluid_new(&in);
        check_below(distance(f, p == 2, p == 0 || p == 3 ? 1 : 2, p == 3, 1, mean), 1e-13);
        check_below(fluid_measures_of(f).divergence_max, 1e-13);
        fluid_free(f);
    }
}

/* On oblong cells the second component's height is not length_b/length_a but the value that the cells' continuity
 * requires, so that the projection changes nothing. */
static void on_oblong_cells(void **state) {
    (void)state;
    struct fluid_input in = box((int[3]){8, 12, 6}, (double[3]){1, 3, 2});
    in.vortices = (struct fluid_vortices){1, {1, 1, 1}};
    struct fluid *f = fluid_new(&in);
    const double h = 8 * sin(M_PI / 8) / 1 / (12 * sin(M_PI / 12) / 3);
    check_below(distance(f, 0, 1, 1, h, (double[3]){0}), 1e-13);
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(in_every_plane_and_in_space), cmocka_unit_test(on_oblong_cells))
