/* J and K of a crack's tip in a plate with bonds, of displacements that are given. */
#include "solid/measure/intensity.h"
#include "physics/crack_tip.h"
#include "solid/measure/stress.h"
#include "tests/check.h"
#include "tests/solid/make_plate.h"

/* d = G x about the middle. */
static void strain(struct solid *s, const double g[2][2]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 2; c++) s->d[c][h] = g[c][0] * s->x0[0][h] + g[c][1] * s->x0[1][h];
    solid_ghosts_update(s);
}

/* Plane stress. */
static double energy_density(const double g[2][2], double nu) {
    const double shear = g[0][1] + g[1][0];
    return YOUNG / (2 * (1 - nu * nu)) *
           (g[0][0] * g[0][0] + g[1][1] * g[1][1] + 2 * nu * g[0][0] * g[1][1] + 0.5 * (1 - nu) * shear * shear);
}

/* In a uniform strain J is 0: to rounding on a lattice about which the tip is symmetric, nearly so on irregular points.
 * Beside a crack that the stress runs along K_I and K_II are small, and J is the energy that the faces' layers lack,
 * some quarter of a spacing each: the same at each radius. The size of a term: W radius. */
static void uniform_at(double nu) {
    const int bonds_alone = nu == 1. / 3; /* the faces' layers then lack what is said above */
    const double e = 1e-7, general[2][2] = {{e, 0.3 * e}, {-0.7 * e, 0.4 * e}}, along[2][2] = {{e, 0}, {0, -e * nu}};
    const double line[2][3] = {{-SPACING, 20 * SPACING, 0}, {20 * SPACING, 20 * SPACING, 0}};
    const struct solid_cut cut = {2, line};
    const struct solid_tip tip = {{20 * SPACING, 20 * SPACING}, {1, 0}};
    const double radius[2] = {12 * SPACING, 18 * SPACING};
    for (int kind = 0; kind < (bonds_alone ? 3 : 2); kind++) {
        const double w = energy_density(kind == 2 ? along : general, nu);
        struct solid_intensity is[2];
        struct solid *s = make((struct make){.sites = {40, 40},
                                             .irregular = kind == 1 ? 0.1 : 0,
                                             .cuts = kind == 2,
                                             .cut = kind == 2 ? &cut : NULL,
                                             .ratio_excess = bonds_alone ? 0 : nu - 1. / 3});
        strain(s, kind == 2 ? along : general);
        solid_intensity_measure(s, &tip, 0, 2, radius, is);
        for (int k = 0; k < 2; k++) {
            check_close(is[k].j / (w * radius[k]), 0, kind ? 5e-2 : 1e-11);
            if (kind) assert_true(fabs(is[k].j / (w * radius[k])) > 1e-6); /* no zero by accident */
            for (int m = 0; m < 2 && kind == 2; m++) check_close(is[k].k[m] / (sqrt(radius[k]) * YOUNG * e), 0, 2e-2);
            if (kind == 2) check_relative(is[k].t, YOUNG * e, 0.1);
        }
        if (kind == 2) {
            check_relative(is[0].j, is[1].j, 0.05);
            check_between(is[0].j / (w * SPACING), -0.6, -0.4);
        }
        assert_true(solid_intensity_is_inside(s, &tip, 18 * SPACING));
        assert_true(!solid_intensity_is_inside(s, &tip, 21.5 * SPACING));
        solid_free(s);
    }
}

static void uniform(void **state) {
    (void)state;
    static const double ratios[] = {1. / 3, 0.1, 0.2, 0.45};
    for (int k = 0; k < 4; k++) uniform_at(ratios[k]);
}

/* Largest error of J E'/(K_I^2 + K_II^2) - 1 and of K over hypot(K_I, K_II), of the crack's own field in a plate of n
 * spacings, with a crack at an angle. */
static double error_of(int n, double ratio, double angle, int irregular, enum physics_model model, double excess,
                       const double k[2]) {
    const double c = cos(angle), sn = sin(angle), half = 0.5 * n * SPACING;
    const double line[2][3] = {{half - 2 * half * c, half - 2 * half * sn, 0}, {half, half, 0}};
    const struct solid_cut cut = {2, line};
    const struct solid_tip tip = {{half, half}, {c, sn}};
    const double nu = physics_model_poisson_ratio(model) + excess;
    const struct physics_crack_tip own = {YOUNG, nu, model == PHYSICS_PLANE_STRAIN};
    struct solid *s = make((struct make){.sites = {n, n},
                                         .model = model,
                                         .ratio = ratio,
                                         .irregular = irregular ? 0.1 : 0,
                                         .cuts = 1,
                                         .cut = &cut,
                                         .ratio_excess = excess});
    for (int h = 0; h < s->n; h++) {
        const double x[2] = {s->x0[0][h] - half, s->x0[1][h] - half};
        const double at[2] = {c * x[0] + sn * x[1], c * x[1] - sn * x[0]}, r = hypot(at[0], at[1]);
        double stress[3], u[2], slope[2], sum[2] = {0, 0};
        for (int m = 0; m < 2 && r > 0; m++) {
            physics_crack_tip_field(&own, m, r, atan2(at[1], at[0]), stress, u, slope);
            for (int d = 0; d < 2; d++) sum[d] += k[m] * u[d];
        }
        s->d[0][h] = c * sum[0] - sn * sum[1];
        s->d[1][h] = c * sum[1] + sn * sum[0];
    }
    solid_ghosts_update(s);
    const double radius[2] = {0.6 * half, 0.9 * half}, size = hypot(k[0], k[1]);
    double worst = 0;
    struct solid_intensity is[2];
    solid_intensity_measure(s, &tip, 0, 2, radius, is);
    for (int i = 0; i < 2; i++) {
        worst = check_worst(worst, is[i].j * physics_crack_tip_modulus(&own) / (size * size) - 1);
        for (int m = 0; m < 2; m++) worst = check_worst(worst, (is[i].k[m] - k[m]) / size);
        check_relative(is[i].k_j * is[i].k_j, is[i].j * physics_crack_tip_modulus(&own), 1e-12);
    }
    solid_free(s);
    return worst;
}

/* Of both modes, along and across the lattice, on irregular points: the error at m = 3 is that of the lattice's moduli
 * (2 % in C11), and goes with m and the number of spacings. */
static void own_field(void **state) {
    (void)state;
    const double k[3][2] = {{1e3, 0}, {0, 1e3}, {1e3, -7e2}};
    const struct {
        int mode, irregular;
        double angle;
        enum physics_model model;
        double excess;
    } kind[] = {{0, 0, 0, PHYSICS_PLANE_STRESS, 0},      {1, 0, 0, PHYSICS_PLANE_STRAIN, 0},
                {2, 0, 0.6, PHYSICS_PLANE_STRESS, 0},    {2, 1, -2.5, PHYSICS_PLANE_STRAIN, 0},
                {0, 0, 0, PHYSICS_PLANE_STRESS, -0.2},   {1, 0, 0, PHYSICS_PLANE_STRAIN, 0.05},
                {2, 0, 0.6, PHYSICS_PLANE_STRAIN, -0.1}, {2, 1, -2.5, PHYSICS_PLANE_STRESS, 0.1}};
    for (int i = 0; i < 8; i++) {
        if (check_skips(i + 1, 8)) continue;
        const double coarse =
            error_of(40, 3, kind[i].angle, kind[i].irregular, kind[i].model, kind[i].excess, k[kind[i].mode]);
        const double fine =
            error_of(160, 5, kind[i].angle, kind[i].irregular, kind[i].model, kind[i].excess, k[kind[i].mode]);
        check_below(coarse, 0.025);
        check_below(fine, 0.01);
        check_below(fine, 0.5 * coarse);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(uniform), cmocka_unit_test(own_field)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
