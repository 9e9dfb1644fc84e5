/* Bond forces of fields for which they are known exactly: affine, quadratic, rotated. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/check.h"

/* Force density if every bond of a full family were stretched to twice its length. */
static double force_scale(const struct solid *s) {
    return solid_material_micromodulus(s->in.material, SPACING) * 4. / 3 * M_PI * pow(3 * SPACING, 3) / DENSITY;
}

static int interior(const struct solid *s, int h, const int sites[3], int layers) {
    for (int c = 0; c < 3; c++) {
        const double x = s->x0[c][h] / SPACING;
        if (x < layers || x > sites[c] - layers) return 0;
    }
    return 1;
}

/* A homogeneous deformation leaves the interior without force; strains small (series) and large (square root). */
static void test_affine(void **state) {
    (void)state;
    const int sites[3] = {14, 15, 16};
    for (int list = 0; list < 2; list++)
        for (int large = 0; large < 2; large++) {
            struct solid *s = make((struct make){.sites = {14, 15, 16}, .list = list});
            const double gradient[3][3] = {{1.0, -0.4, 0.7}, {0.2, -1.3, 0.1}, {-0.6, 0.3, 0.5}};
            const double strain = large ? 0.1 : 3e-4;
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++)
                    for (int k = 0; k < 3; k++) s->d[c][h] += strain * gradient[c][k] * s->x0[k][h];
            solid_ghosts_update(s);
            solid_force(s, 0);
            int seen = 0;
            double outside = 0;
            for (int h = 0; h < s->n; h++) {
                for (int c = 0; c < 3; c++) {
                    if (interior(s, h, sites, 6)) check_close(s->a[c][h] / (strain * force_scale(s)), 0, 1e-12);
                    outside = check_worst(outside, s->a[c][h]);
                }
                seen += interior(s, h, sites, 6);
            }
            assert_int_equal(par_sum_long(seen), 2 * 3 * 4);
            check_above(par_max(outside), 1e-3 * strain * force_scale(s)); /* faces do have a force */
            solid_free(s);
        }
}

/* u_x = a x_k^2: force 2 a C11 (k = x) or 2 a C44, with the lattice's constants. */
static void test_quadratic(void **state) {
    (void)state;
    const int sites[3] = {8, 9, 8};
    for (int list = 0; list < 2; list++)
        for (int k = 0; k < 3; k++) {
            struct solid *s = make((struct make){.sites = {8, 9, 8}, .list = list, .uncorrected = 1});
            const double a = 1e-7 / SPACING, modulus = k == 0 ? 1.02041 * 1.2 * YOUNG : 1.00872 * 0.4 * YOUNG;
            for (int h = 0; h < s->n; h++) s->d[0][h] = a * pow(s->x0[k][h] - 4 * SPACING, 2);
            solid_ghosts_update(s);
            solid_force(s, 0);
            int seen = 0;
            for (int h = 0; h < s->n; h++) {
                if (!interior(s, h, sites, 3)) continue;
                seen++;
                check_close(s->a[0][h] * DENSITY / (2 * a * modulus), 1, 2e-5);
            }
            check_above(par_sum_long(seen), 0);
            solid_free(s);
        }
}

static void rotate(const struct solid *s, int h, double angle, double x[3]) { /* Rodrigues, about (1,2,3)/sqrt(14) */
    const double k[3] = {1 / sqrt(14), 2 / sqrt(14), 3 / sqrt(14)};
    const double r[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]};
    const double dot = k[0] * r[0] + k[1] * r[1] + k[2] * r[2];
    for (int c = 0; c < 3; c++) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        x[c] = r[c] * cos(angle) + (k[d] * r[e] - k[e] * r[d]) * sin(angle) + k[c] * dot * (1 - cos(angle));
    }
}

/* Turned by any angle, a body is free of force and loses no bond. */
static void test_rotation(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {10, 9, 8}, .list = list, .fracture_energy = 1e-8});
        const double s0 = solid_material_critical_stretch(s->in.material, SPACING);
        check_below(s0, 2e-7);
        for (double angle = 0.1; angle < 6.3; angle += 0.7) {
            for (int h = 0; h < s->n; h++) {
                double x[3];
                rotate(s, h, angle, x);
                for (int c = 0; c < 3; c++) s->d[c][h] = x[c] - s->x0[c][h];
            }
            solid_ghosts_update(s);
            solid_force(s, 1);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) check_close(s->a[c][h] / force_scale(s), 0, 1e-13);
        }
        solid_family_count(s);
        assert_int_equal(s->bonds_broken, 0);
        assert_int_equal(s->broke, 0);
        solid_free(s);
    }
}

/* The forces of a strained and rotated body are those of the strained body, rotated: with the square root and with the
 * series. */
static void test_objective(void **state) {
    (void)state;
    for (int large = 0; large < 2; large++) {
        struct solid *s = make((struct make){.sites = {9, 8, 7}}), *turned = make((struct make){.sites = {9, 8, 7}});
        const double strain = large ? 0.02 : 2e-4, angle = 1.1;
        for (int h = 0; h < s->n; h++) {
            double before[3], x[3];
            for (int c = 0; c < 3; c++) {
                s->d[c][h] = strain * SPACING * noise(s, h, c);
                before[c] = s->x0[c][h];
                s->x0[c][h] += s->d[c][h];
            }
            rotate(s, h, angle, x);
            for (int c = 0; c < 3; c++) {
                s->x0[c][h] = before[c];
                turned->d[c][h] = x[c] - before[c];
            }
        }
        solid_ghosts_update(s);
        solid_ghosts_update(turned);
        solid_force(s, 0);
        solid_force(turned, 0);
        double most = 0;
        for (int h = 0; h < s->n; h++) {
            double a2 = 0, b2 = 0;
            for (int c = 0; c < 3; c++) a2 += s->a[c][h] * s->a[c][h], b2 += turned->a[c][h] * turned->a[c][h];
            check_close((sqrt(a2) - sqrt(b2)) / force_scale(s), 0, 1e-13);
            most = fmax(most, sqrt(a2));
        }
        check_above(par_max(most), 0.01 * strain * force_scale(s));
        solid_free(s);
        solid_free(turned);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_affine),
        cmocka_unit_test(test_quadratic),
        cmocka_unit_test(test_rotation),
        cmocka_unit_test(test_objective),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
