/* Microelastic constants and critical stretches, by the integrals that define them. */
#include "base/par.h"
#include "solid/law/material.h"
#include "tests/check.h"

static const double YOUNG = 65e9, G0 = 204, THICKNESS = 2e-3, DELTA = 3e-3;

/* c(xi): constant, or falling to 0 at the horizon. */
static double c_at(const struct physics_bond *k, enum physics_micromodulus kind, double xi) {
    return kind == PHYSICS_CONICAL ? k->c * (1 - xi / DELTA) : k->c;
}

/* A solid in which every bond has the stretch s holds the energy density of Hooke's law: 3 E s^2 in space (nu = 1/4),
 * 8/5 E s^2 in plane strain, 3/2 E s^2 in plane stress (nu = 1/3). A plane crack that cuts every bond across it at s0
 * takes G0 an area. A polynomial of a low degree in xi: Gauss's two points an interval are exact for a cubic, many
 * intervals for the rest. */
static void energies_of_the_bonds(void **state) {
    (void)state;
    const enum physics_model model[3] = {PHYSICS_3D, PHYSICS_PLANE_STRAIN, PHYSICS_PLANE_STRESS};
    const double hooke[3] = {3, 1.6, 1.5};
    enum { INTERVALS = 1000 };
    for (int m = 0; m < 3; m++)
        for (int conical = 0; conical < 2; conical++) {
            const enum physics_micromodulus kind = conical ? PHYSICS_CONICAL : PHYSICS_CONSTANT;
            const struct solid_material material = {YOUNG, 2440, G0, 3, kind, 0, 0};
            const struct physics_bond k = solid_material_constants(model[m], THICKNESS, &material, DELTA);
            double energy = 0, crack = 0;
            for (int n = 0; n < 2 * INTERVALS; n++) {
                const double xi = DELTA / INTERVALS * (n / 2 + 0.5 + (n % 2 ? 0.5 : -0.5) / sqrt(3));
                const double c = c_at(&k, kind, xi), step = 0.5 * DELTA / INTERVALS;
                const double shell = m == 0 ? 4 * M_PI * xi * xi : 2 * M_PI * xi * THICKNESS;
                const double crossing =
                    m == 0 ? M_PI / 2 * xi * xi * xi : THICKNESS * xi * xi; /* bonds an area, by length */
                energy += 0.5 * (0.5 * c * xi) * shell * step;
                crack += 2 * (0.5 * c * k.s0 * k.s0 * xi) * crossing * step;
            }
            check_relative(energy, hooke[m] * YOUNG, 1e-10);
            check_relative(crack, G0, 1e-10);
        }
}

/* The numbers of a lattice are the same ones; what never breaks has an infinite stretch. */
static void lattice_numbers(void **state) {
    (void)state;
    const struct solid_material material = {YOUNG, 2440, G0, 3, PHYSICS_CONSTANT, 0, 0},
                                endless = {YOUNG, 2440, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct physics_bond k = solid_material_constants(PHYSICS_3D, 0, &material, DELTA);
    check_relative(solid_material_micromodulus(&material, DELTA / 3), k.c, 1e-14);
    check_relative(solid_material_critical_stretch(&material, DELTA / 3), k.s0, 1e-14);
    check_equal(solid_material_constants(PHYSICS_PLANE_STRESS, THICKNESS, &endless, DELTA).s0, INFINITY);
    check_equal(solid_material_critical_stretch(&endless, DELTA), INFINITY);
}

struct material_case {
    double young, energy, ratio, spacing;
    enum physics_model model;
    double c, s0, within;
};

/* Numbers that theses print for their materials.  (000: tables 4, 9, 13; 003; 001) */
static void printed_numbers(void **state) {
    (void)state;
    const struct material_case row[] = {
        {65e9, 204, 3, 1e-3, PHYSICS_PLANE_STRESS, 6.897e18, 1.2086e-3, 1e-4},
        {72e9, 135, 3, 1e-3, PHYSICS_PLANE_STRESS, 7.639e18, 9.342e-4, 1e-4},
        {72e9, 135, 3, 5e-4, PHYSICS_PLANE_STRESS, 6.112e19, 1.3211e-3, 1e-4},
        {191e9, 38590, 3, 2e-3, PHYSICS_PLANE_STRAIN, 2.702e18, 6.639e-3, 1e-4},
        {190e9, 22170, 3, 1e-3, PHYSICS_PLANE_STRAIN, 2.1504e19, 7.135e-3, 1e-4},
        {71.4e9, 1000, 3, 1e-3, PHYSICS_PLANE_STRAIN, 8.081e18, 2.472e-3, 1e-4},
        {1e8, 0.05, 3, 1.5625e-3, PHYSICS_3D, 7.9116e17, 2.9814e-4, 1e-4},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        const struct solid_material m = {row[k].young, 3000, row[k].energy, row[k].ratio, PHYSICS_CONSTANT, 0, 0};
        const struct physics_bond is = solid_material_constants(row[k].model, 1, &m, row[k].ratio * row[k].spacing);
        check_close(is.c / row[k].c, 1, row[k].within);
        check_close(is.s0 / row[k].s0, 1, row[k].within);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(energies_of_the_bonds), cmocka_unit_test(lattice_numbers),
                                       cmocka_unit_test(printed_numbers)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
