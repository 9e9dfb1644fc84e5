/* Bonds that are stretched: the largest stretch by a few of them, and the rate of the solid about its displacements. */
#include "solid/step/strained.h"
#include "solid/bonds/ghosts.h"
#include "solid/step/rates.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* d = (F - 1) X */
static void deform(struct solid *s, const double f[3][3]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = -s->x0[c][h];
            for (int k = 0; k < 3; k++) s->d[c][h] += f[c][k] * s->x0[k][h];
        }
    solid_ghosts_update(s);
}

static struct solid *block(int list) {
    struct solid *s = make((struct make){.sites = {7, 8, 6}, .list = list});
    s->stage.integrator = SOLID_VERLET;
    return s;
}

/* Two particles that can only move across their bond of stretch s: the rate is s/(1 + s) of that along it. */
static void across(void **state) {
    (void)state;
    const struct solid_constraint guide = {.low = {-1, -1, -1}, .high = {1, 1, 1}, .direction = {1, 0, 1}};
    for (int list = 0; list < 2; list++) {
        struct solid *s = make(
            (struct make){.sites = {2, 1, 1}, .list = list, .uncorrected = 1, .constraints = 1, .constraint = &guide});
        for (int k = 0; k < 4; k++) {
            const double stretch = 0.05 * k * k;
            pair_set(s, stretch * SPACING, 0);
            check_close(solid_rates_strained(s), pair_stiffness() * stretch / (1 + stretch), 1e-4 * pair_stiffness());
        }
        solid_free(s);
    }
}

/* A turned block has the rate of the block at rest, one that is stretched in all directions a greater one: at most by
 * the part of the bonds' stiffness that turns, s/(1 + s) of two directions for that of one. Nothing of the state
 * changes. */
static void block_rates(void **state) {
    (void)state;
    const double turned[3][3] = {{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}},
                 stretched[3][3] = {{1.2, 0, 0}, {0, 1.2, 0}, {0, 0, 1.2}}, part = 0.2 / 1.2;
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(list);
        struct solid_rates rest;
        solid_rates_of(s, &rest);
        check_relative(solid_rates_strained(s), rest.stiffness, 2e-3);
        deform(s, turned);
        check_relative(solid_rates_strained(s), rest.stiffness, 2e-3);
        deform(s, stretched);
        const double rate2 = solid_rates_strained(s), x = s->d[0][0];
        print_message("stretched by a fifth: %.4f of the rate\n", rate2 / rest.stiffness);
        check_between(rate2 / rest.stiffness, 1 + 0.3 * part, 1 + 2 * part);
        check_equal(s->d[0][0], x);
        solid_free(s);
    }
}

/* A bond along x is among the chosen ones of some particle: the stretch is exact for a block that is stretched along
 * it, 0 for one that is turned or hardly moved. */
static void largest(void **state) {
    (void)state;
    const double along[3][3] = {{1.15, 0, 0}, {0, 0.98, 0}, {0, 0, 1}},
                 turned[3][3] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                 little[3][3] = {{1.0005, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(list);
        struct solid_strained *strained = solid_strained_new(s);
        assert_non_null(strained);
        deform(s, little);
        check_equal(solid_strained_stretch(strained), 0);
        deform(s, turned);
        check_close(solid_strained_stretch(strained), 0, 1e-12);
        deform(s, along);
        check_close(solid_strained_stretch(strained), 0.15, 1e-12);
        deform(s, little);
        check_close(solid_strained_stretch(strained), 0.0005, 1e-12);
        solid_strained_free(strained);
        solid_free(s);
    }
}

/* Bonds that break at a thousandth are not followed, unless the stage breaks none. */
static void brittle(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {4, 4, 4}, .fracture_energy = 1e-2});
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1};
    assert_null(solid_strained_new(s));
    s->stage.breakage = 0;
    struct solid_strained *strained = solid_strained_new(s);
    assert_non_null(strained);
    solid_strained_free(strained);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest alone[] = {cmocka_unit_test(across)}; /* on one rank */
    const struct CMUnitTest tests[] = {cmocka_unit_test(block_rates), cmocka_unit_test(largest),
                                       cmocka_unit_test(brittle)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    if (par_size() == 1) failed += cmocka_run_group_tests(alone, NULL, NULL);
    par_end();
    return failed;
}
