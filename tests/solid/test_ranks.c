/* The same motion on any number of ranks and threads and in both bond stores: a body that is loaded, damped, driven and
 * breaks. One rank writes its results to a file; more ranks compare with it. */
#include "tests/solid/make.h"
#include "solid/bonds/soft.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "base/threads.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef COMPARES
#    define COMPARES 0 /* 1: built for another kind of machine, and one rank compares too */
#endif

enum { SITES = 13 * 12 * 14 };

static struct solid *run(int list, int verlet, int softens, double ratio_excess) {
    const struct solid_material brittle = {YOUNG, DENSITY, 1e-4, 3, PHYSICS_CONSTANT, 0, 0};
    const double strength = 0.6 * YOUNG * solid_material_critical_stretch(&brittle, SPACING);
    const struct solid_constraint constraint[2] = {
        {.low = {-1, -1, -1}, .high = {1, 3 * SPACING, 1}, .direction = {1, 1, 1}},
        {.low = {-1, 9 * SPACING, -1}, .high = {1, 1, 1}, .direction = {0, 1, 0}, .velocity = {0, 0.02, 0}}};
    struct solid *s = make((struct make){.sites = {13, 12, 14},
                                         .periodic = {0, 0, 1},
                                         .list = list,
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .fracture_energy = 1e-4,
                                         .tensile_strength = softens ? strength : 0,
                                         .ratio_excess = ratio_excess});
    s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3,
                                    .breakage = 1,
                                    .damping_relative = 1e13,
                                    .damping_absolute = 100};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->load[c][h] = 5e5 * noise(s, h, c);
    solid_integrate(s, step_of(0.9), 4);
    solid_family_count(s);
    return s;
}

/* State by place in the lattice, on every rank: d, v, lost weight and what is left of softening bonds; then energies
 * and counts. */
static void collect(struct solid *s, double *all) {
    static struct solid_family_view view;
    memset(all, 0, (8 * SITES + 8) * sizeof *all);
    for (int h = 0; h < s->n; h++) {
        int at[3];
        for (int c = 0; c < 3; c++) at[c] = (int)floor(s->x0[c][h] / SPACING);
        double *here = all + 8 * ((at[2] * 12 + at[1]) * 13 + at[0]);
        for (int c = 0; c < 3; c++) {
            here[c] = s->d[c][h] / SPACING;
            here[3 + c] = s->v[c][h];
        }
        solid_family_view(s, h, &view);
        const double c0 = solid_material_micromodulus(s->in.material, s->in.spacing);
        for (int b = 0; b < view.n; b++) {
            here[6] += view.intact[b] ? 0 : b + 1;
            here[7] += view.intact[b] ? 1e-2 * (1 - view.micro[b] / c0) : 0;
        }
    }
    double *sum = all + 8 * SITES;
    sum[0] = solid_energy_measure(s).damped / par_size();
    sum[1] = s->e_fracture;
    sum[2] = s->e_constraint;
    sum[3] = s->work_load;
    par_sum_array(all, 8 * SITES + 8);
    for (int i = 0; i < 4; i++) sum[i] /= sum[3] + sum[2];
    sum[4] = (double)s->bonds_broken;
    sum[5] = (double)s->n_global;
}

static void compare(const double *all, const double *expected) {
    for (int i = 0; i < 8 * SITES + 8; i++) check_close(all[i], expected[i], 1e-12);
}

static void test_same(void **state) {
    (void)state;
    static double all[8 * SITES + 8], expected[8 * SITES + 8];
    static const double excess[4] = {0, 0, -0.1, 0.15};
    for (int kind = 0; kind < 8; kind++) { /* brittle, softening; the same with Poisson's ratios of 0.15 and 0.4 */
        const int verlet = kind & 1, softens = kind >> 1 & 1;
        if (par_size() <= 2 && check_skips(kind, COMPARES ? 6 : 3)) continue;
        char path[512];
        snprintf(path, sizeof path, FRANA_BINARY_DIR "/solid_test_ranks_%d.data", kind);
        for (int list = 0; list < 2; list++) {
            struct solid *s = run(list, verlet, softens, excess[kind >> 1]);
            check_between(s->bonds_broken, 100, s->bonds_total / 4);
            if (threads_count() > 1 && !list) check_at_least(s->family->lattice[0]->segments->slabs[0].n, 3);
            if (softens) check_above(par_sum_long(s->soft->n), 1000);
            collect(s, list ? expected : all);
            solid_free(s);
        }
        compare(all, expected); /* lattice and lists */
        if (par_size() == 1 && threads_count() == 1 && !COMPARES) {
            FILE *file = fopen(path, "wb");
            assert_non_null(file);
            assert_int_equal(fwrite(all, sizeof all, 1, file), 1);
            assert_int_equal(fclose(file), 0);
        } else {
            FILE *file = fopen(path, "rb");
            if (!file) fail_msg("%s: run this test on one rank first", path);
            assert_int_equal(fread(expected, sizeof expected, 1, file), 1);
            fclose(file);
            compare(all, expected);
        }
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_same)};
    int failed = 0;
    for (int threads = 1; threads <= (par_size() > 1 || COMPARES ? 1 : 3); threads += 2) {
        threads_set(threads);
        failed |= cmocka_run_group_tests(tests, NULL, NULL);
    }
    par_end();
    return failed;
}
