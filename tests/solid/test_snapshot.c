/* A snapshot of the solid comes back to the bit, and the same steps from it give the same bits again. */
#include "solid/bonds/ghosts.h"
#include "solid/bonds/soft.h"
#include "solid/snapshot.h"
#include "solid/step/integrate.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>

/* A block under loads and damping, in which a few bonds are about to break, or to soften and break. */
static struct solid *block(int list, int verlet, int softens) {
    const struct solid_material brittle = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const double strength = 0.8 * YOUNG * solid_material_critical_stretch(&brittle, SPACING);
    struct solid *s = make((struct make){
        .sites = {8, 6, 5}, .list = list, .fracture_energy = 0.05, .tensile_strength = softens ? strength : 0});
    s->stage.breakage = 1;
    s->stage.damping_absolute = 1e4;
    s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = 1.4e-4 * SPACING * noise(s, h, c);
            s->v[c][h] = 0.05 * noise(s, h, c + 3);
            s->load[c][h] = 1e5 * noise(s, h, c + 6);
        }
    solid_ghosts_update(s);
    return s;
}

enum { NUMBERS = 7, SOFT = 128 };

/* What a state is to be compared by: d, v, time, energies, bits of the bonds. Owned by the caller. */
static double *record_of(const struct solid *s, size_t *bytes) {
    const size_t of_bonds = (size_t)solid_family_bytes(s), n = (size_t)s->n;
    *bytes = (6 * n + NUMBERS) * sizeof(double) + n * (of_bonds + SOFT * sizeof(double));
    double *record = calloc(1, *bytes);
    for (int c = 0; c < 3; c++) {
        memcpy(record + (size_t)c * n, s->d[c], n * sizeof(double));
        memcpy(record + (size_t)(3 + c) * n, s->v[c], n * sizeof(double));
    }
    const double number[NUMBERS] = {s->t,
                                    s->e_damped,
                                    s->e_fracture,
                                    s->e_constraint,
                                    s->work_load,
                                    (double)s->n,
                                    (double)solid_family_directed(s)};
    memcpy(record + 6 * n, number, sizeof number);
    uint8_t *bits = (uint8_t *)(record + 6 * n + NUMBERS);
    for (int h = 0; h < s->n; h++) solid_family_save(s, h, bits + (size_t)h * of_bonds);
    double *left = (double *)(bits + n * of_bonds); /* what softening bonds have kept */
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) left[(size_t)h * SOFT + (size_t)(b % SOFT)] = view.micro[b];
    }
    return record;
}

static void again_and_again(void **state) {
    (void)state;
    for (int kind = 0; kind < 8; kind++) {
        if (check_skips(kind ^ kind >> 1 ^ kind >> 2, 2)) continue; /* by day every pair of choices */
        struct solid *s = block(kind & 1, kind >> 1 & 1, kind >> 2);
        struct solid_snapshot *keep = solid_snapshot_new(s, NULL, 1);
        const double dt = step_of(0.2);
        size_t bytes;
        solid_integrate(s, dt, 2);
        solid_family_count(s);
        const long before = s->bonds_broken;
        if (s->soft) check_above(par_sum_long(s->soft->n), 50);
        solid_snapshot_take(keep, s, NULL);
        double *start = record_of(s, &bytes), *end = NULL;
        for (int round = 0; round < 3; round++) {
            solid_integrate(s, dt, 4);
            solid_family_count(s);
            check_above(s->bonds_broken, before);
            double *now = record_of(s, &bytes);
            if (end) assert_memory_equal(now, end, bytes);
            if (!end) end = now;
            if (now != end) free(now);
            solid_snapshot_restore(keep, s, NULL);
            now = record_of(s, &bytes);
            assert_memory_equal(now, start, bytes);
            free(now);
            solid_family_count(s);
            check_equal(s->bonds_broken, before);
        }
        free(start);
        free(end);
        solid_snapshot_free(keep);
        solid_free(s);
    }
}

/* Two states one after the other: back to the later, then to the earlier one. */
static void two_states(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        if (check_skips(kind ^ kind >> 1, 2)) continue;
        struct solid *s = block(kind & 1, 1, kind >> 1);
        struct solid_snapshot *keep[2] = {solid_snapshot_new(s, NULL, 1), solid_snapshot_new(s, NULL, 1)};
        double *was[2];
        size_t bytes;
        for (int k = 0; k < 2; k++) {
            solid_integrate(s, step_of(0.2), 3);
            solid_snapshot_take(keep[k], s, NULL);
            was[k] = record_of(s, &bytes);
        }
        check_equal(memcmp(was[0], was[1], bytes) != 0, 1);
        for (int k = 1; k >= 0; k--) {
            solid_integrate(s, step_of(0.2), 3);
            solid_snapshot_restore(keep[k], s, NULL);
            double *now = record_of(s, &bytes);
            assert_memory_equal(now, was[k], bytes);
            free(now);
        }
        for (int k = 0; k < 2; k++) {
            free(was[k]);
            solid_snapshot_free(keep[k]);
        }
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(again_and_again), cmocka_unit_test(two_states)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
