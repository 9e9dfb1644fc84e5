/* Energies, damage, stress, strain and tensor invariants of known states. */
#include "solid/bonds/ghosts.h"
#include "solid/law/material.h"
#include "solid/measure/damage.h"
#include "solid/measure/energy.h"
#include "solid/measure/stress.h"
#include "solid/measure/tensors.h"
#include "solid/solid.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *cube_new(int n, int general, int correction) {
    const struct solid_body body = bodies_box(0, 0, 0, n, n, n);
    struct solid_input in = bodies_input(1, &body);
    in.general_bonds = general;
    in.surface_correction = correction;
    return solid_new(&in);
}

/* d = g X0. */
static void strain_affine(struct solid *s, double g[3][3]) {
    for (int h = 0; h < s->n; h++)
        for (int i = 0; i < 3; i++) s->d[i][h] = g[i][0] * s->x0[0][h] + g[i][1] * s->x0[1][h] + g[i][2] * s->x0[2][h];
    solid_ghosts_update(s);
}

static int is_within(const struct solid *s, int h, int low, int high) {
    int p[3];
    bodies_site(s, h, p);
    for (int c = 0; c < 3; c++)
        if (p[c] < low || p[c] > high) return 0;
    return 1;
}

/* In the bulk: the lattice's stiffness (m = 3, partial volumes: C11 = 1.02041 * 1.2 E, C12 = C44 = 1.00872 * 0.4 E). */
static void stress_of_uniform_strain(void **state) {
    (void)state;
    const double c11 = 1.02041 * 1.2 * YOUNG, c44 = 1.00872 * 0.4 * YOUNG;
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_new(8, general, 0);
        double(*stress)[6] = malloc(((size_t)s->n + 1) * sizeof *stress);
        for (int k = 0; k < 6; k++) {
            double g[3][3] = {{0}};
            const double size = 1e-7, weight = k < 3 ? 1 : 0.5;
            g[k % 3][k < 3 ? k : (k + 1) % 3] = size;
            strain_affine(s, g);
            solid_stress_measure(s, stress);
            for (int h = 0; h < s->n; h++) {
                if (!is_within(s, h, 3, 4)) continue;
                for (int j = 0; j < 6; j++) {
                    const double c = k < 3 ? (j == k ? c11 : j < 3 ? c44 : 0) : j == k ? 2 * c44 : 0;
                    check_close(stress[h][j], c * weight * size, 1e-3 * c44 * size);
                }
            }
        }
        free(stress);
        solid_free(s);
    }
}

/* Exact for affine displacements at every particle, also at faces, edges and corners, whichever bonds are broken; zero
 * for a rotation. */
static void strain_of_affine_fields(void **state) {
    (void)state;
    struct solid *s = cube_new(7, 0, 1);
    double(*strain)[6] = malloc(((size_t)s->n + 1) * sizeof *strain);
    struct solid_family_view view;
    for (int broken = 0; broken < 2; broken++) {
        double g[3][3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) g[i][j] = 1e-2 * (bodies_random(3 * i + j, 1) - 0.5);
        strain_affine(s, g);
        solid_stress_strain(s, strain);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                const int k = (c + 1) % 3;
                double e = g[c][c], shear = 0.5 * (g[c][k] + g[k][c]);
                for (int i = 0; i < 3; i++) {
                    e += 0.5 * g[i][c] * g[i][c];
                    shear += 0.5 * g[i][c] * g[i][k];
                }
                check_close(strain[h][c], e, 1e-14);
                check_close(strain[h][3 + c], shear, 1e-14);
            }
        bodies_turn(s, 1.1, 0.3);
        solid_ghosts_update(s);
        solid_stress_strain(s, strain);
        for (int h = 0; h < s->n; h++)
            for (int k = 0; k < 6; k++) check_close(strain[h][k], 0, 1e-12);
        bodies_cut(s, 1, 3);
        for (int h = 0; h < s->n; h++) { /* and half of the bonds along a diagonal */
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++)
                if (view.intact[b] && fabs(view.xi[b][0] - view.xi[b][1]) < 0.1 * SPACING) solid_family_break(s, h, b);
        }
    }
    free(strain);
    solid_free(s);
}

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

/* A cube turned, every particle moved by up to half of `by` spacings, and cut. */
static struct solid *cube_uneven(int general, double by) {
    struct solid *s = cube_new(9, general, 1);
    bodies_turn(s, 0.4, 0);
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        for (int c = 0; c < 3; c++) s->d[c][h] += by * SPACING * (bodies_random(p[0] + 9 * (p[1] + 9 * p[2]), c) - 0.5);
    }
    bodies_cut(s, 2, 4);
    solid_ghosts_update(s);
    return s;
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

/* Rows of eight and lists give every particle the same stress, strain and damage. */
static void tensors_of_both_stores(void **state) {
    (void)state;
    enum { SIDE = 9, ALL = SIDE * SIDE * SIDE };
    double(*of)[ALL][13] = calloc(2, sizeof *of); /* by store and site */
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_uneven(general, 0.05);
        double(*stress)[6] = malloc(((size_t)s->n + 1) * sizeof *stress),
        (*strain)[6] = malloc(((size_t)s->n + 1) * sizeof *strain), *phi = malloc(((size_t)s->n + 1) * sizeof *phi),
        *largest = malloc(((size_t)s->n + 1) * sizeof *largest);
        solid_stress_measure(s, stress);
        solid_stress_strain(s, strain);
        solid_damage_measure(s, phi);
        solid_tensors_largest(s->n, stress, largest);
        for (int h = 0; h < s->n; h++) {
            int p[3];
            double value[3];
            bodies_site(s, h, p);
            double *to = of[general][p[0] + SIDE * (p[1] + SIDE * p[2])];
            memcpy(to, stress[h], sizeof *stress);
            memcpy(to + 6, strain[h], sizeof *strain);
            to[12] = phi[h];
            solid_tensors_principal(stress[h], value);
            check_close(largest[h], value[0], 1e-13 * fabs(value[0]));
        }
        free(largest);
        free(phi);
        free(strain);
        free(stress);
        solid_free(s);
    }
    par_sum_array(&of[0][0][0], 2 * ALL * 13); /* numbered in other orders, they may be on other ranks */
    double most[3] = {0, 0, 0}, apart[3] = {0, 0, 0};
    for (int i = 0; i < ALL; i++)
        for (int k = 0; k < 13; k++) {
            most[k / 6] = check_worst(most[k / 6], of[0][i][k]);
            apart[k / 6] = check_worst(apart[k / 6], of[0][i][k] - of[1][i][k]);
        }
    for (int q = 0; q < 3; q++) {
        check_above(most[q], 0);
        check_below(apart[q], 1e-12 * most[q]);
    }
    free(of);
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

/* Beside a crack, layer by layer: the broken part of the families at a flat face. Of a complete family's .98989 V0
 * these remain: .6142, .8341, .9704. */
static void damage_beside_a_cut(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 10, 10, 12);
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        for (int c = 0; c < 2; c++) {
            in.periodic[c] = 1;
            in.length[c] = 10 * SPACING;
        }
        in.length[2] = 1;
        struct solid *s = solid_new(&in);
        double *phi = malloc(((size_t)s->n + 1) * sizeof *phi);
        solid_damage_measure(s, phi);
        for (int h = 0; h < s->n; h++) check_equal(phi[h], 0);
        bodies_cut(s, 2, 6);
        solid_damage_measure(s, phi);
        const double left[3] = {.6142 / .98989, .8341 / .98989, .9704 / .98989};
        for (int h = 0; h < s->n; h++) {
            int p[3];
            bodies_site(s, h, p);
            const int depth = p[2] < 6 ? 5 - p[2] : p[2] - 6;
            if (depth < 3) check_close(1 - phi[h] - left[depth], 0, 1e-3);
            if (depth >= 3) check_equal(phi[h], 0);
        }
        free(phi);
        solid_free(s);
    }
}

static void invariants(void **state) {
    (void)state;
    double value[3], vector[3][3];
    solid_tensors_principal((double[]){1, 5, -2, 0, 0, 0}, value);
    check_equal(value[0], 5);
    check_equal(value[1], 1);
    check_equal(value[2], -2);
    check_close(solid_tensors_von_mises((double[]){7, 0, 0, 0, 0, 0}), 7, 1e-14);
    check_close(solid_tensors_von_mises((double[]){0, 0, 0, 3, 0, 0}), 3 * sqrt(3), 1e-14);
    check_close(solid_tensors_von_mises((double[]){4, 4, 4, 0, 0, 0}), 0, 1e-14);
    solid_tensors_principal((double[]){0, 0, 0, 0, 0, 2}, value);
    check_close(value[0], 2, 1e-14);
    check_close(value[1], 0, 1e-14);
    check_close(value[2] + 2, 0, 1e-14);
    for (int k = 0; k < 200; k++) {
        double t[6], trace = 0, norm = 0;
        for (int i = 0; i < 6; i++) t[i] = bodies_random(k, i) - 0.5;
        if (k % 4 == 0) t[3] = t[4] = 0;           /* a block */
        if (k % 4 == 1) t[0] = t[1], t[3] *= 1e-9; /* nearly a double value */
        for (int c = 0; c < 3; c++) {
            trace += t[c];
            norm += t[c] * t[c] + 2 * t[3 + c] * t[3 + c];
        }
        solid_tensors_eigen(t, value, vector);
        check_at_least(value[0], value[1]);
        check_at_least(value[1], value[2]);
        check_close(value[0] + value[1] + value[2] - trace, 0, 1e-14);
        check_close(value[0] * value[0] + value[1] * value[1] + value[2] * value[2] - norm, 0, 1e-14);
        for (int i = 0; i < 3; i++) {
            const double *v = vector[i];
            const double tv[3] = {t[0] * v[0] + t[3] * v[1] + t[5] * v[2], t[3] * v[0] + t[1] * v[1] + t[4] * v[2],
                                  t[5] * v[0] + t[4] * v[1] + t[2] * v[2]};
            for (int c = 0; c < 3; c++) check_close(tv[c], value[i] * v[c], 1e-14);
            for (int j = 0; j < 3; j++) {
                const double dot = v[0] * vector[j][0] + v[1] * vector[j][1] + v[2] * vector[j][2];
                check_close(dot, i == j, 1e-14);
            }
        }
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_of_uniform_strain),
        cmocka_unit_test(strain_of_affine_fields),
        cmocka_unit_test(strain_energy_of_the_bulk),
        cmocka_unit_test(kinetic_energy),
        cmocka_unit_test(strain_energy_of_any_deformation),
        cmocka_unit_test(tensors_of_both_stores),
        cmocka_unit_test(damage_beside_a_cut),
        cmocka_unit_test(invariants),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
