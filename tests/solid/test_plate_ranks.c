/* A plate under every load has the same motion to the bit on any number of ranks. */
/* A plate that is driven, loaded, damped, torn and compressed has the same motion to the bit on any number of ranks.
 * One rank writes its results to a file; more ranks compare with it. */
#include "tests/solid/make_plate.h"
#include "solid/bonds/soft.h"
#include "solid/contact/contact.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

#include <stdio.h>

enum { VALUES = 5 };

static struct solid *run(int verlet, int softens, double ratio_excess) {
    const struct solid_material brittle = {YOUNG, DENSITY, G0, 3, PHYSICS_CONSTANT, 0, 0};
    const double s0 = solid_material_constants(PHYSICS_PLANE_STRESS, THICKNESS, &brittle, 3 * SPACING).s0;
    const double t[2] = {0, 3e-6}, factor[2] = {0.2, 1};
    const struct solid_time time = {2, t, factor, 0};
    const double line[2][3] = {{10 * SPACING, 0, 0}, {14 * SPACING, 11 * SPACING, 0}};
    const struct solid_cut cut = {2, line};
    const struct solid_constraint constraint[2] = {
        {.low = {0, 0}, .high = {3 * SPACING, 1}, .direction = {1, 1}},
        {.low = {27 * SPACING, 0}, .high = {1, 1}, .direction = {1, 0}, .velocity = {9, 0}, .time = time}};
    const struct solid_load load = {.kind = SOLID_LOAD_EDGE,
                                    .edge = {{0, 22 * SPACING}, {20 * SPACING, 22 * SPACING}},
                                    .traction = {0, -4e7},
                                    .time = time};
    struct solid *s = make((struct make){.sites = {30, 22},
                                         .brittle = 1,
                                         .tensile_strength = softens ? 0.6 * YOUNG * s0 : 0,
                                         .ratio_excess = ratio_excess,
                                         .contact = 1,
                                         .correction = verlet ? SOLID_CORRECTION_ENERGY : SOLID_CORRECTION_VOLUME,
                                         .cuts = 1,
                                         .cut = &cut,
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .loads = 1,
                                         .load = &load});
    s->stage =
        (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1, .damping_relative = 1e16};
    for (int i = 0; i < 100; i++) {
        solid_contact_update(s);
        solid_integrate(s, step_of(0.3), 2);
    }
    solid_family_count(s);
    return s;
}

/* d, v and the sum of the numbers of broken bonds, of all particles in the order of their ids; malloc'ed. */
static double *collect(const struct solid *s) {
    static struct solid_family_view view;
    double *mine = calloc((size_t)s->n * VALUES + 1, sizeof *mine);
    for (int h = 0; h < s->n; h++) {
        double *to = mine + VALUES * h;
        for (int c = 0; c < 2; c++) {
            to[c] = s->d[c][h];
            to[2 + c] = s->v[c][h];
        }
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) to[4] += view.intact[b] ? 0 : b + 1;
    }
    size_t bytes;
    double *all = par_all_gather_any(mine, (size_t)s->n * VALUES * sizeof *mine, &bytes);
    free(mine);
    assert_int_equal(bytes, (size_t)s->n_global * VALUES * sizeof *all);
    return all;
}

static void test_ranks(void **state) {
    (void)state;
    for (int kind = 0; kind < 6; kind++) { /* brittle, softening, with a Poisson's ratio of 0.2 */
        struct solid *s = run(kind & 1, kind >> 1 == 1, kind >> 1 == 2 ? 0.2 - 1. / 3 : 0);
        double *all = collect(s);
        const size_t n = (size_t)s->n_global * VALUES;
        char path[512];
        snprintf(path, sizeof path, "%s/solid_plate_%d.bin", FRANA_BINARY_DIR, kind);
        check_above(s->bonds_broken, 300);
        if (s->soft) check_above(par_sum_long(s->soft->n), 300);
        if (par_size() == 1) {
            FILE *file = fopen(path, "wb");
            assert_non_null(file);
            assert_int_equal(fwrite(all, sizeof *all, n, file), n);
            fclose(file);
        } else {
            FILE *file = fopen(path, "rb");
            double *before = malloc(n * sizeof *before);
            assert_non_null(file);
            assert_int_equal(fread(before, sizeof *before, n, file), n);
            fclose(file);
            for (size_t i = 0; i < n; i++)
                if (all[i] != before[i])
                    fail_msg("value %zu of particle %zu: %.17g, on one rank %.17g", i % VALUES, i / VALUES, all[i],
                             before[i]);
            free(before);
        }
        free(all);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_ranks)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
