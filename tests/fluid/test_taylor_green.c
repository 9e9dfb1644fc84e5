/* Two-dimensional Taylor-Green vortices on the staggered grid: the convective term is a discrete gradient, so that the
 * initial field times exp(-2 nu t (2/h)^2 sin^2(h/2)) solves the semi-discrete equations exactly. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

/* The vortices of the plane a, b carried along with the mean flow for the time t, at the face's own place. */
static double exact(const struct fluid_grid *g, int c, int a, int b, const int at[3], double rate, double t,
                    const double mean[3]) {
    double x[3];
    for (int d = 0; d < 3; d++) x[d] = (at[d] + g->lo[d] + (d == c ? 1.0 : 0.5)) * g->d[d] - mean[d] * t;
    if (c == a) return mean[c] + sin(x[a]) * cos(x[b]) * exp(-rate * t);
    if (c == b) return mean[c] - cos(x[a]) * sin(x[b]) * exp(-rate * t);
    return mean[c];
}

/* Of the pressure, whose mean is 0. */
static double root_mean_square(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) sum += pow(component(f, 3)[fluid_grid_at(g, i, j, k)], 2);
    return sqrt(par_sum(sum) / (double)fluid_cells(f));
}

struct how {
    int is_apart;     /* 1: the momentum equation has its own pressure */
    double *pressure; /* root mean square at the end, Pa; or NULL */
};

static double error_of(int n, double nu, double dt, int steps, int a, int b, const double mean[3], double *divergence,
                       struct how how) {
    const double l = 2 * M_PI;
    const int across = how.is_apart ? 12 : 4; /* at least three cells a rank */
    const double wide = 0.25 * across;
    struct fluid_input in = {
        .n = {across, across, across}, .length = {wide, wide, wide}, .density = 2.5, .viscosity = nu};
    in.immersed = in.mean_pressure = how.is_apart;
    in.n[a] = in.n[b] = n;
    in.length[a] = in.length[b] = l;
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    const double h = l / n, rate = 2 * nu * pow(2 / h * sin(h / 2), 2);
    for (int pass = 0; pass < 2; pass++) {
        double worst = 0;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const double value = exact(g, c, a, b, (int[3]){i, j, k}, rate, pass ? steps * dt : 0, mean);
                        double *q = component(f, c) + fluid_grid_at(g, i, j, k);
                        if (pass)
                            worst = check_worst(worst, (*q - value));
                        else
                            *q = value;
                    }
        if (pass) {
            *divergence = fluid_measures_of(f).divergence_max * h;
            if (how.pressure) *how.pressure = root_mean_square(f);
            fluid_free(f);
            return par_max(worst);
        }
        fluid_state_refresh(f);
        for (int s = 0; s < steps; s++) fluid_step(f, dt);
    }
    return 0;
}

static double error(int n, double nu, double dt, int steps, int a, int b, const double mean[3], double *divergence) {
    return error_of(n, nu, dt, steps, a, b, mean, divergence, (struct how){.is_apart = 0});
}

static const double still[3] = {0, 0, 0};
static const int plane[3][2] = {{0, 1}, {0, 2}, {1, 2}};

static void decays_exactly_in_every_plane(void **state) {
    (void)state;
    for (int p = 0; p < 3; p++) {
        double divergence;
        const double e = error(32, 0.1, 0.01, 100, plane[p][0], plane[p][1], still, &divergence);
        check_below(e, 1e-8);
        check_below(divergence, 1e-12);
    }
}

/* The velocity is of third order whichever pressure the momentum equation reads, and without a force between prediction
 * and projection the same, to round-off. The written pressure is that of the last stage, or, beside a predictor
 * pressure, the mean over the step: both are of first order, and their difference too. */
static void orders_in_time(void **state) {
    (void)state;
    double divergence, e[2][4], p[2][4];
    for (int apart = 0; apart < 2; apart++) {
        for (int i = 0; i < 4; i++)
            e[apart][i] = error_of(16, 1.0, 0.025 / (1 << i), 20 << i, 0, 1, still, &divergence,
                                   (struct how){.is_apart = apart, .pressure = &p[apart][i]});
        for (int i = 0; i < 2; i++) {
            const double velocity = log2(e[apart][i] / e[apart][i + 1]);
            const double pressure = log2((p[apart][i] - p[apart][i + 1]) / (p[apart][i + 1] - p[apart][i + 2]));
            print_message("%s: order of u %.3f, of p %.3f\n", apart ? "mean pressure" : "last pressure", velocity,
                          pressure);
            check_between(velocity, 2.7, 3.3);
            check_between(pressure, 0.9, 1.1);
        }
    }
    for (int i = 0; i < 4; i++) {
        check_close(e[1][i], e[0][i], 1e-12);
        if (i > 0) check_between(log2((p[1][i - 1] - p[0][i - 1]) / (p[1][i] - p[0][i])), 0.9, 1.1);
    }
}

/* A uniform flow across the plane changes nothing; one within the plane carries the vortices, with an error that falls
 * with the square of the cell. */
static void carried_by_a_mean_flow(void **state) {
    (void)state;
    for (int p = 0; p < 3; p++) {
        const int a = plane[p][0], b = plane[p][1];
        double mean[3] = {0, 0, 0}, divergence;
        mean[3 - a - b] = 0.7;
        check_below(error(32, 0.1, 0.01, 100, a, b, mean, &divergence), 1e-8);
        check_below(divergence, 1e-12);
        mean[a] = 1;
        mean[b] = -0.5;
        const double coarse = error(16, 0.1, 0.02, 20, a, b, mean, &divergence),
                     fine = error(32, 0.1, 0.02, 20, a, b, mean, &divergence);
        const double order = log2(coarse / fine);
        if (!(order > 1.8 && order < 2.2)) fail_msg("order %g (errors %g %g)", order, coarse, fine);
        check_below(divergence, 1e-12);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(decays_exactly_in_every_plane), cmocka_unit_test(orders_in_time),
                cmocka_unit_test(carried_by_a_mean_flow))
