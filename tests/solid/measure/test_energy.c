/* Kinetic and strain energy of known states, in both stores. */
#include "solid/law/material.h"
#include "solid/measure/energy.h"
#include "tests/solid/measure/cubes.h"
#include "tests/check.h"

/* The energy of a cube of N particles under one strain is a cubic in N once faces do not see each other: its third
 * difference is six times the bulk's. Isotropic: W/W0 = 1.01574; along x: C11/(1.2 E). */
static void strain_energy_of_the_bulk(void **state) {
    (void)state;
    const double size = 1e-6, volume = SPACING * SPACING * SPACING;
    for (int k = 0; k < 2; k++) {
        double energy[4];
        for (int n = 0; n < 4; n++) {
            struct solid *s = cube_new(6 + n, n % 2, 0);
            double g[3][3] = {{size, 0, 0}, {0, k ? 0 : size, 0}, {0, 0, k ? 0 : size}};
            strain_affine(s, g);
            energy[n] = solid_energy_measure(s).strain;
            check_equal(solid_energy_measure(s).kinetic, 0);
            solid_free(s);
        }
        const double bulk = (energy[3] - 3 * energy[2] + 3 * energy[1] - energy[0]) / 6;
        const double w0 = k ? 0.5 * 1.2 * YOUNG * size * size : 3 * YOUNG * size * size;
        check_close(bulk / (w0 * volume), k ? 1.02041 : 1.01574, 1e-3);
    }
}

static void kinetic_energy(void **state) {
    (void)state;
    struct solid *s = cube_new(5, 0, 1);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->v[c][h] = c + 1;
    const double expected = 0.5 * DENSITY * 125 * SPACING * SPACING * SPACING * 14;
    check_relative(solid_energy_measure(s).kinetic, expected, 1e-12);
    check_equal(solid_energy_measure(s).strain, 0);
    solid_free(s);
}

/* Both stores, and the view's own sum with s = |zeta|/|xi| - 1, in an uneven deformation with broken bonds, large or so
 * small that the sum has but ten digits. */
static void strain_energy_of_any_deformation(void **state) {
    (void)state;
    double energy[2], sum = 0;
    for (int trial = 0; trial < 4; trial++) {
        const int general = trial % 2;
        struct solid *s = cube_uneven(general, trial < 2 ? 0.05 : 5e-4);
        struct solid_family_view view;
        energy[general] = solid_energy_measure(s).strain; /* with fresh ghosts */
        sum = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                double xi = 0, zeta = 0;
                for (int c = 0; c < 3; c++) {
                    const double z = view.xi[b][c] + s->d[c][view.l[b]] - s->d[c][h];
                    xi += view.xi[b][c] * view.xi[b][c];
                    zeta += z * z;
                }
                const double stretch = sqrt(zeta / xi) - 1;
                sum += view.intact[b] * 0.25 * solid_material_micromodulus(&bodies_material, SPACING) * view.alpha[b] *
                       stretch * stretch * sqrt(xi) * view.weight[b] * s->volume[h];
            }
        }
        sum = par_sum(sum);
        check_relative(energy[general], sum, 1e-10);
        if (general) check_relative(energy[0], energy[1], 1e-12);
        solid_free(s);
    }
}

/* Two neighbours, the bond stretched by s and turned: the energy c0 s^2 |xi| V^2/2, half of it at either end; nothing
 * of it once the bond is broken. */
static void two_particles(void **state) {
    (void)state;
    const double stretch = 0.07, volume = SPACING * SPACING * SPACING;
    const double c0 = solid_material_micromodulus(&bodies_material, SPACING);
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 2, 1, 1);
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        in.surface_correction = 0;
        struct solid *s = solid_new(&in);
        double energy[2], largest[2];
        for (int h = 0; h < s->n; h++)
            if (s->x0[0][h] > SPACING) {
                s->d[0][h] = (0.6 * (1 + stretch) - 1) * SPACING;
                s->d[2][h] = 0.8 * (1 + stretch) * SPACING;
            }
        solid_ghosts_update(s);
        const double expected = 0.5 * c0 * stretch * stretch * SPACING * volume * volume;
        check_relative(solid_energy_measure(s).strain, expected, 1e-12);
        solid_energy_bonds(s, energy, largest);
        for (int h = 0; h < s->n; h++) {
            check_relative(energy[h] * volume, expected / 2, 1e-12);
            check_relative(largest[h], stretch, 1e-12);
        }
        for (int h = 0; h < s->n; h++) solid_family_break(s, h, 0);
        check_equal(solid_energy_measure(s).strain, 0);
        solid_energy_bonds(s, energy, largest);
        for (int h = 0; h < s->n; h++) {
            check_equal(energy[h], 0);
            check_equal(largest[h], -1);
        }
        solid_free(s);
    }
}

/* The energies of the particles make up the whole solid's. */
static void parts_of_the_whole(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_uneven(general, 0.05);
        double *energy = malloc(((size_t)s->n + 1) * sizeof *energy), sum = 0;
        double *stretch = malloc(((size_t)s->n + 1) * sizeof *stretch);
        solid_energy_bonds(s, energy, stretch);
        for (int h = 0; h < s->n; h++) sum += energy[h] * s->volume[h];
        sum = par_sum(sum);
        check_relative(solid_energy_measure(s).strain, sum, 1e-11);
        free(stretch);
        free(energy);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(strain_energy_of_the_bulk), cmocka_unit_test(kinetic_energy),
                                       cmocka_unit_test(strain_energy_of_any_deformation),
                                       cmocka_unit_test(two_particles), cmocka_unit_test(parts_of_the_whole)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
