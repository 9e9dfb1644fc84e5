/* Sums over a lattice's family: constants, horizon depth, surface correction, bond counts. */
#include "tests/solid/make.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/check.h"

static double ball(void) { return 4. / 3 * M_PI * pow(3 * SPACING, 3); }

/* Lattice sums of an interior particle against the table for m = 3 with partial volumes; the table has five digits. */
static void constants(int list) {
    struct solid *s = make((struct make){.sites = {8, 8, 8}, .periodic = {1, 1, 1}, .list = list});
    static struct solid_family_view view;
    const double c0 = solid_material_micromodulus(s->in.material, SPACING);
    assert_int_equal(s->n_global, 512);
    assert_int_equal(s->bonds_total, 512 * 178 / 2);
    for (int h = 0; h < s->n; h += 7) {
        solid_family_view(s, h, &view);
        assert_int_equal(view.n, 178);
        double c11 = 0, c44 = 0, isotropic = 0, volume = 0, cleaved = 0;
        for (int b = 0; b < view.n; b++) {
            const double *xi = view.xi[b], length = sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
            const double f = 0.5 * c0 * view.weight[b] * view.alpha[b] / (length * length * length);
            c11 += f * xi[0] * xi[0] * xi[0] * xi[0];
            c44 += f * xi[0] * xi[0] * xi[1] * xi[1];
            isotropic += 0.25 * c0 * length * view.weight[b];
            volume += view.weight[b];
            if (xi[0] > 0) cleaved += 0.5 * c0 * length * view.weight[b] * xi[0];
            assert_true(view.intact[b]);
        }
        check_close(volume / ball(), 0.98989, 1e-4);
        check_close(s->family_volume[h] / volume, 1, 1e-14);
        check_close(c11 / (1.2 * YOUNG), 1.02041, 1e-4);
        check_close(c44 / (0.4 * YOUNG), 1.00872, 1e-4);
        check_close((c11 - 2 * c44 * c44 / (c11 + c44)) / YOUNG, 1.02449, 1e-4);
        check_close(c44 / (c11 + c44), 0.24785, 1e-4);
        check_close(isotropic / (3 * YOUNG), 1.01574, 1e-4);
        const struct solid_material brittle = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
        const double s0 = solid_material_critical_stretch(&brittle, SPACING);
        check_close(s0, 2.9814e-4, 1e-8);
        check_close(cleaved * s0 * s0 / 0.05, 1.01313, 1e-4);
    }
    check_close(c0 / 7.9116e17, 1, 1e-4);
    solid_free(s);
}

static void test_constants_lattice(void **state) { (void)state, constants(0); }
static void test_constants_list(void **state) { (void)state, constants(1); }

/* Family volume by depth below a face, and in plates of one, two and three particles. */
static void depth(int list, int thickness, int layers, const double *expected) {
    struct solid *s = make((struct make){.sites = {8, thickness, 8}, .periodic = {1, 0, 1}, .list = list});
    for (int h = 0; h < s->n + s->n_ghost; h++) {
        const int layer = (int)floor(s->x0[1][h] / SPACING);
        if (layer < layers) check_close(s->family_volume[h] / ball(), expected[layer], 1e-4);
    }
    solid_free(s);
}

static void test_depth(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        depth(list, 10, 4, (double[]){0.6142, 0.8341, 0.9704, 0.98989});
        depth(list, 1, 1, (double[]){0.2384});
        depth(list, 2, 2, (double[]){0.4583, 0.4583});
        depth(list, 3, 3, (double[]){0.5947, 0.6782, 0.5947});
    }
}

/* The surface correction is symmetric and one in the bulk. */
static void test_correction(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {9, 8, 8}, .list = list});
        const double full = 0.98989 * ball();
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++)
                check_close(view.alpha[b], 2 * full / (s->family_volume[h] + s->family_volume[view.l[b]]), 1e-4);
        }
        solid_free(s);
    }
}

/* The main case's medium at full size: the count of its particles, and a body numbered without gaps on any ranks. */
static void test_porous_count(void **state) {
    (void)state;
    struct solid_body body = {.name = "medium", .shape = SOLID_BOX, .low = {0, -3, 0}, .high = {48, 67, 64}};
    for (int c = 0; c < 3; c++) body.low[c] *= SPACING, body.high[c] *= SPACING;
    body.cavity_period = 16 * SPACING;
    body.cavity_radius = 9.2 * SPACING;
    const struct solid_material material = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {
        .spacing = SPACING, .bodies = 1, .body = &body, .materials = 1, .material = &material, .surface_correction = 1};
    struct solid *s = solid_new(&in);
    assert_int_equal(s->n_global, 54720);
    assert_int_equal(par_sum_long(s->n), 54720);
    check_below(s->n, 1.2 * 54720 / par_size());
    double moment = 0;
    for (int h = 0; h < s->n; h++) moment += s->x0[1][h];
    check_close(par_sum(moment) / 54720, 32 * SPACING, 1e-12);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_constants_lattice), cmocka_unit_test(test_constants_list), cmocka_unit_test(test_depth),
        cmocka_unit_test(test_correction),        cmocka_unit_test(test_porous_count),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
