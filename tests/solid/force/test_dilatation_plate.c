/* Plates of any Poisson's ratio: elastic constants, forces that are the energy's derivative, mirror images. */
#include "solid/force/dilatation.h"
#include "solid/force/force.h"
#include "solid/force/strain.h"
#include "solid/law/material.h"
#include "solid/measure/stress.h"
#include "solid/step/integrate.h"
#include "tests/check.h"
#include "tests/solid/derivative.h"
#include "tests/solid/make_plate.h"

static const double ratios[] = {-0.5, 0, 0.1, 0.2, 0.3, 0.4, 0.45};
enum { RATIOS = sizeof ratios / sizeof *ratios };

static double own_ratio(enum physics_model model) { return physics_model_poisson_ratio(model); }

/* The modulus of equal stretches is exact, that of shear has the lattice's anisotropy and partial volumes. */
static void test_constants(void **state) {
    (void)state;
    const double e = 1e-8;
    for (int model = PHYSICS_PLANE_STRESS; model <= PHYSICS_PLANE_STRAIN; model++)
        for (int k = 0; k < RATIOS; k++) {
            const double nu = ratios[k], mu = YOUNG / (2 * (1 + nu)),
                         bulk = model == PHYSICS_PLANE_STRESS ? YOUNG / (2 * (1 - nu))
                                                              : YOUNG / (2 * (1 + nu) * (1 - 2 * nu));
            struct solid *s = make((struct make){.sites = {21, 21},
                                                 .model = (enum physics_model)model,
                                                 .ratio = 4,
                                                 .ratio_excess = nu - own_ratio((enum physics_model)model)});
            double(*stress)[6] = calloc((size_t)s->n + 1, sizeof *stress);
            for (int h = 0; h < s->n; h++) s->d[0][h] = e * s->x0[0][h];
            solid_ghosts_update(s);
            solid_stress_measure(s, stress);
            for (int h = 0; h < s->n; h++) {
                if (fabs(s->x0[0][h] / SPACING - 10.5) > 0.1 || fabs(s->x0[1][h] / SPACING - 10.5) > 0.1) continue;
                check_relative((stress[h][0] + stress[h][1]) / e, 2 * bulk, 1e-6);
                check_relative((stress[h][0] - stress[h][1]) / e, 2 * mu, 0.04);
                check_close(stress[h][2] / e, model == PHYSICS_PLANE_STRAIN ? 2 * nu * bulk : 0, 1e-6 * bulk);
            }
            free(stress);
            solid_free(s);
        }
}

static void test_derivative(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int k = 0; k < RATIOS; k++)
        for (int kind = 0; kind < 4; kind++) {
            struct solid *s = make((struct make){
                .sites = {17, 15},
                .model = kind & 1 ? PHYSICS_PLANE_STRAIN : PHYSICS_PLANE_STRESS,
                .irregular = kind & 2 ? 0.2 : 0,
                .ratio_excess = ratios[k] - own_ratio(kind & 1 ? PHYSICS_PLANE_STRAIN : PHYSICS_PLANE_STRESS)});
            const double step = 1e-5;
            for (int h = 0; h < s->n && par_size() == 1; h++) {
                solid_family_view(s, h, &view);
                for (int b = 0; b < view.n; b++)
                    if (view.intact[b] && noise(s, h, 100 + b) > 0.3) solid_family_break(s, h, b);
            }
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 2; c++) s->d[c][h] = 1e-3 * SPACING * noise(s, h, c);
            check_derivative(s, step, noise);
            solid_free(s);
        }
}

/* A plate pulled apart, brittle: its energies close, and its two halves are mirror images to the bit. */
static void test_pulled(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++)
        for (int k = 0; k < 2; k++) {
            struct solid *s = make((struct make){.sites = {31, 20}, .brittle = 1, .ratio_excess = k ? 0.1 : -0.2});
            s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
            for (int h = 0; h < s->n; h++) {
                const double x = s->x0[0][h] / SPACING - 15.5, y = s->x0[1][h] / SPACING - 10;
                s->v[0][h] = 2 * rint(64 * x) / 64 * (1 + 0.01 * y * y);
                s->v[1][h] = 0.1 * rint(64 * y) / 64;
            }
            solid_ghosts_update(s);
            const struct solid_energy before = solid_energy_measure(s);
            solid_integrate(s, 0.1 * SPACING / sqrt(YOUNG / DENSITY), 400);
            const struct solid_energy after = solid_energy_measure(s);
            const double all = before.kinetic;
            solid_family_count(s);
            check_above(s->bonds_broken, 100);
            check_close((after.kinetic + after.strain + after.fracture) / all, 1, 1e-5);
            if (par_size() == 1)
                for (int h = 0; h < s->n; h++)
                    for (int l = 0; l < s->n; l++)
                        if (fabs(s->x0[0][h] + s->x0[0][l] - 31 * SPACING) < 0.1 * SPACING &&
                            fabs(s->x0[1][h] - s->x0[1][l]) < 0.1 * SPACING) {
                            check_equal(s->d[0][h], -s->d[0][l]);
                            check_equal(s->d[1][h], s->d[1][l]);
                        }
            solid_free(s);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_constants), cmocka_unit_test(test_derivative),
                                       cmocka_unit_test(test_pulled)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
