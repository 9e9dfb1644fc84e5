/* Bonds break at the critical stretch from both ends, and unbreakable ones do not. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/check.h"

/* Every bond has the same stretch s: below s0 none breaks, above it all break and release the energy that they
 * stored. */
static void dilate(struct make m, double of_s0, int expect_broken) {
    struct solid *s = make(m);
    const double s0 = solid_material_critical_stretch(s->in.material, SPACING);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = of_s0 * s0 * s->x0[c][h];
    solid_ghosts_update(s);
    const double held = energy_of(s, NULL);
    solid_force(s, 1);
    solid_family_count(s);
    assert_int_equal(s->bonds_broken, expect_broken ? s->bonds_total : 0);
    assert_int_equal(par_sum_long(s->broke), expect_broken ? par_size() : 0);
    if (expect_broken) {
        check_close(par_sum(s->e_fracture) / held, 1, 1e-12);
        check_close(energy_of(s, NULL), 0, 0);
        for (int h = 0; h < s->n; h++) {
            assert_true(s->flag[h] & SOLID_BROKEN);
            for (int c = 0; c < 3; c++) check_equal(s->a[c][h], 0);
        }
    }
    solid_free(s);
}

static void test_critical_stretch(void **state) {
    (void)state;
    /* s0 = 3e-4: the series; 2e-2: the square root */
    for (int list = 0; list < 2; list++)
        for (int tough = 0; tough < 2; tough++) {
            const struct make m = {.sites = {9, 8, 7}, .list = list, .fracture_energy = tough ? 225. : 0.05};
            dilate(m, 0.999, 0);
            dilate(m, 1.001, 1);
            dilate(m, -10, 0); /* compression */
        }
}

static uint64_t name_of(const struct solid *s, int h) {
    uint64_t z = 7;
    for (int c = 0; c < 3; c++) z = (z ^ (uint64_t)lrint(s->x0[c][h] / SPACING * 2)) * 0x9e3779b97f4a7c15u + 12345;
    return z ^ z >> 31;
}

/* An antisymmetric function of a bond's ends, summed over the directed broken bonds: 0 if they broke from both ends. */
static long unpaired(const struct solid *s, long *broken) {
    static struct solid_family_view view;
    uint64_t sum = 0;
    long count = 0;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            if (view.intact[b]) continue;
            const uint64_t here = name_of(s, h), there = name_of(s, view.l[b]);
            sum += here * here * there - here * there * there;
            count++;
        }
    }
    *broken = par_sum_long(count);
    return par_sum_long((long)sum);
}

static void test_symmetric(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++)
        for (int tough = 0; tough < 2; tough++) {
            struct solid *s =
                make((struct make){.sites = {12, 11, 13}, .list = list, .fracture_energy = tough ? 225. : 0.05});
            const double s0 = solid_material_critical_stretch(s->in.material, SPACING);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) s->d[c][h] = 6 * s0 * SPACING * noise(s, h, c);
            solid_ghosts_update(s);
            for (int i = 0; i < 3; i++) solid_force(s, 1);
            long directed;
            assert_int_equal(unpaired(s, &directed), 0);
            check_between(directed, s->bonds_total / 4, 3 * s->bonds_total / 2);
            solid_family_count(s);
            assert_int_equal(2 * s->bonds_broken, directed);
            solid_free(s);
        }
}

/* Thousands of bonds at the limit but for a few units in the last place still break from both ends or from neither. */
static void test_symmetric_at_the_limit(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {12, 11, 13}, .list = list, .fracture_energy = 0.05});
        const double s0 = solid_material_critical_stretch(s->in.material, SPACING);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = s0 * s->x0[c][h] * (1 + 1e-13 * noise(s, h, c)) + 0.1;
        solid_ghosts_update(s);
        solid_force(s, 1);
        long directed;
        assert_int_equal(unpaired(s, &directed), 0);
        check_between(directed, s->bonds_total / 10, 2 * s->bonds_total);
        solid_free(s);
    }
}

static void test_unbreakable(void **state) {
    (void)state;
    static struct solid_family_view view;
    const struct solid_region low = {.low = {-1, -1, -1}, .high = {1, 4 * SPACING, 1}};
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){
            .sites = {9, 10, 8}, .list = list, .fracture_energy = 0.05, .unbreakables = 1, .unbreakable = &low});
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = 0.01 * s->x0[c][h];
        solid_ghosts_update(s);
        s->stage.breakage = 0;
        solid_force(s, 1);
        assert_int_equal(s->broke, 0); /* a stage in which nothing breaks */
        s->stage.breakage = 1;
        solid_force(s, 0);
        assert_int_equal(s->broke, 0); /* an inner stage of Runge-Kutta */
        solid_force(s, 1);
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++)
                assert_int_equal(view.intact[b], s->x0[1][h] < 4 * SPACING || s->x0[1][view.l[b]] < 4 * SPACING);
        }
        solid_free(s);
    }
}

/* Cleaving the bulk on a plane by hand costs G(100), and lambda survives being saved and loaded. */
static void test_cleave(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int list = 0; list < 2; list++) {
        struct make m = {.sites = {14, 8, 8}, .periodic = {0, 1, 1}, .list = list, .fracture_energy = 0.05};
        struct solid *s = make(m), *again = make(m);
        const double s0 = solid_material_critical_stretch(s->in.material, SPACING), plane = 7 * SPACING;
        const double c0 = solid_material_micromodulus(s->in.material, SPACING);
        double released = 0;
        long crossing = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double *xi = view.xi[b];
                if ((s->x0[0][h] < plane) == (s->x0[0][h] + xi[0] < plane)) continue;
                released += 0.25 * c0 * s0 * s0 * view.alpha[b] * view.weight[b] * s->volume[h] *
                            sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
                crossing++;
                if (view.intact[b]) solid_family_break(s, h, b);
            }
        }
        check_close(par_sum(released) / (64 * SPACING * SPACING) / 0.05, 1.01313, 1e-4);
        solid_family_count(s);
        assert_int_equal(2 * s->bonds_broken, par_sum_long(crossing));
        uint8_t bits[64];
        assert_int_equal(solid_family_bytes(s), 23);
        for (int h = 0; h < s->n; h++) {
            solid_family_save(s, h, bits);
            solid_family_load(again, h, bits);
        }
        solid_family_count(again);
        assert_int_equal(again->bonds_broken, s->bonds_broken);
        for (int h = 0; h < s->n; h++) {
            const int near = fabs(s->x0[0][h] - plane) < 3 * SPACING;
            assert_int_equal(!!(s->flag[h] & SOLID_BROKEN), near);
            assert_int_equal(again->flag[h], s->flag[h]);
        }
        /* the two halves move apart freely */
        for (int h = 0; h < s->n; h++) again->d[0][h] = again->x0[0][h] < plane ? 0 : SPACING;
        solid_ghosts_update(again);
        solid_force(again, 1);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) check_close(again->a[c][h], 0, 1e-9);
        assert_int_equal(again->broke, 0);
        solid_free(s);
        solid_free(again);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_critical_stretch),
        cmocka_unit_test(test_symmetric),
        cmocka_unit_test(test_symmetric_at_the_limit),
        cmocka_unit_test(test_unbreakable),
        cmocka_unit_test(test_cleave),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
