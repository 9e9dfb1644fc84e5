/* Stress and strain of particles in known states, in both stores. */
#include "solid/law/material.h"
#include "solid/measure/damage.h"
#include "solid/measure/stress.h"
#include "solid/measure/tensors.h"
#include "tests/solid/measure/cubes.h"
#include "tests/check.h"

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
        double(*sorted)[3] = malloc(((size_t)s->n + 1) * sizeof *sorted);
        for (int k = 0; k < 6; k++) {
            double g[3][3] = {{0}};
            const double size = 1e-7, weight = k < 3 ? 1 : 0.5;
            g[k % 3][k < 3 ? k : (k + 1) % 3] = size;
            strain_affine(s, g);
            /* principal values of a uniaxial strain, and of a shear strain of size/2 */
            const double principal[3] = {k < 3 ? c11 : c44, k < 3 ? c44 : 0, k < 3 ? c44 : -c44};
            const double mises = k < 3 ? c11 - c44 : sqrt(3) * c44;
            solid_stress_measure(s, stress);
            solid_tensors_sorted(s->n, stress, sorted);
            for (int h = 0; h < s->n; h++) {
                if (!is_within(s, h, 3, 4)) continue;
                check_close(solid_tensors_von_mises(stress[h]), mises * size, 2e-3 * c44 * size);
                for (int j = 0; j < 3; j++) check_close(sorted[h][j], principal[j] * size, 1e-3 * c44 * size);
                for (int j = 0; j < 6; j++) {
                    const double c = k < 3 ? (j == k ? c11 : j < 3 ? c44 : 0) : j == k ? 2 * c44 : 0;
                    check_close(stress[h][j], c * weight * size, 1e-3 * c44 * size);
                }
            }
        }
        free(sorted);
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

/* Rows of eight and lists give every particle the same stress, strain and damage. */
static void tensors_of_both_stores(void **state) {
    (void)state;
    enum { SIDE = 9, ALL = SIDE * SIDE * SIDE };
    double(*strains)[ALL][13] = calloc(2, sizeof *strains); /* by store and site */
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
            double *to = strains[general][p[0] + SIDE * (p[1] + SIDE * p[2])];
            memcpy(to, stress[h], sizeof *stress);
            memcpy(to + 6, strain[h], sizeof *strain);
            to[12] = phi[h];
            solid_tensors_eigen(stress[h], value, (double[3][3]){{0}});
            check_close(largest[h], value[0], 1e-13 * fabs(value[0]));
        }
        free(largest);
        free(phi);
        free(strain);
        free(stress);
        solid_free(s);
    }
    par_sum_array(&strains[0][0][0], 2 * ALL * 13); /* numbered in other orders, they may be on other ranks */
    double most[3] = {0, 0, 0}, apart[3] = {0, 0, 0};
    for (int i = 0; i < ALL; i++)
        for (int k = 0; k < 13; k++) {
            most[k / 6] = check_worst(most[k / 6], strains[0][i][k]);
            apart[k / 6] = check_worst(apart[k / 6], strains[0][i][k] - strains[1][i][k]);
        }
    for (int q = 0; q < 3; q++) {
        check_above(most[q], 0);
        check_below(apart[q], 1e-12 * most[q]);
    }
    free(strains);
}

/* Two neighbours, the bond stretched by s and turned to e: the flux is c0 s |zeta| V/2 e e. One bond is less than a
 * quarter of a family, so the stress is four times the flux. */
static void two_particles(void **state) {
    (void)state;
    const double stretch = 0.07, e[3] = {0.48, 0.64, 0.6}, volume = SPACING * SPACING * SPACING;
    const double size =
        4 * 0.5 * solid_material_micromodulus(&bodies_material, SPACING) * stretch * (1 + stretch) * SPACING * volume;
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 2, 1, 1);
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        in.surface_correction = 0;
        struct solid *s = solid_new(&in);
        double stress[2][6];
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++)
                s->d[c][h] = s->x0[0][h] > SPACING ? ((1 + stretch) * e[c] - (c == 0)) * SPACING : 0;
        solid_ghosts_update(s);
        solid_stress_measure(s, stress);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                check_relative(stress[h][c], size * e[c] * e[c], 1e-12);
                check_relative(stress[h][3 + c], size * e[c] * e[(c + 1) % 3], 1e-12);
            }
        solid_free(s);
    }
}

/* A rotation on top of a deformation turns the stress with it and leaves Green's strain as it was. */
static void turned_with_the_body(void **state) {
    (void)state;
    const double r[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_uneven(general, 0.05);
        const size_t n = (size_t)s->n + 1;
        double(*stress[2])[6] = {malloc(n * sizeof(double[6])), malloc(n * sizeof(double[6]))};
        double(*strain[2])[6] = {malloc(n * sizeof(double[6])), malloc(n * sizeof(double[6]))};
        double most = 0;
        for (int k = 0; k < 2; k++) {
            solid_stress_measure(s, stress[k]);
            solid_stress_strain(s, strain[k]);
            for (int h = 0; h < s->n; h++) {
                double x[3];
                for (int c = 0; c < 3; c++) x[c] = s->x0[c][h] + s->d[c][h];
                for (int c = 0; c < 3; c++) s->d[c][h] = r[c][0] * x[0] + r[c][1] * x[1] + r[c][2] * x[2] - s->x0[c][h];
            }
            solid_ghosts_update(s);
        }
        for (int h = 0; h < s->n; h++)
            for (int k = 0; k < 3; k++) most = check_worst(most, stress[0][h][k]);
        for (int h = 0; h < s->n; h++) {
            const double *t = stress[0][h];
            const double full[3][3] = {{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}};
            for (int k = 0; k < 6; k++) {
                const int i = k % 3, j = k < 3 ? i : (i + 1) % 3;
                double sum = 0;
                for (int p = 0; p < 3; p++)
                    for (int q = 0; q < 3; q++) sum += r[i][p] * full[p][q] * r[j][q];
                check_close(stress[1][h][k], sum, 1e-11 * most);
                check_close(strain[1][h][k], strain[0][h][k], 1e-12);
            }
        }
        for (int k = 0; k < 2; k++) {
            free(stress[k]);
            free(strain[k]);
        }
        solid_free(s);
    }
}

/* A cube under the uniform strain of uniaxial stress: least and largest stress along it in the layer that is farthest
 * from the ends, over the lattice's. */
static void at_faces(int general, enum solid_correction correction, double range[2]) {
    const double size = 1e-7, nu = 0.247846697482, e = 1.02446908279 * YOUNG; /* of the lattice, m = 3 */
    double g[3][3] = {{size, 0, 0}, {0, -nu * size, 0}, {0, 0, -nu * size}};
    struct solid *s = cube_new(9, general, (int)correction);
    double(*stress)[6] = malloc(((size_t)s->n + 1) * sizeof *stress);
    strain_affine(s, g);
    solid_stress_measure(s, stress);
    range[0] = range[1] = 1;
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        if (p[0] != 4) continue;
        range[0] = fmin(range[0], stress[h][0] / (e * size));
        range[1] = fmax(range[1], stress[h][0] / (e * size));
    }
    range[0] = par_min(range[0]);
    range[1] = par_max(range[1]);
    free(stress);
    solid_free(s);
}

/* A face, an edge and the inside read the same stress, with any correction: the flux alone is 0.63 of it at a face. */
static void stress_at_faces(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++)
        for (int k = 0; k < 3; k++) {
            double range[2];
            at_faces(general, (enum solid_correction)k, range);
            /* the flux of a cut family has parts across the stress, which its share counts: 0.7 % at an edge */
            check_close(range[0], 1, 0.01);
            check_close(range[1], 1, 0.01);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(stress_of_uniform_strain),
                                       cmocka_unit_test(strain_of_affine_fields),
                                       cmocka_unit_test(tensors_of_both_stores),
                                       cmocka_unit_test(stress_at_faces),
                                       cmocka_unit_test(two_particles),
                                       cmocka_unit_test(turned_with_the_body)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
