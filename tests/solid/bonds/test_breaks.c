/* The record of bonds that break: each bond once, sums that agree with e_fracture, and nothing twice after a state was
 * restored. */
#include "solid/bonds/breaks.h"
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/soft.h"
#include "solid/snapshot.h"
#include "solid/measure/events.h"
#include "solid/step/integrate.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>

/* A block with noise for velocities, in which bonds break, or soften and break; periodic in z. */
static struct solid *block(int list, int verlet, int softens) {
    const struct solid_material brittle = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const double strength = 0.5 * YOUNG * solid_material_critical_stretch(&brittle, SPACING);
    struct solid *s = make((struct make){.sites = {6, 5, 8},
                                         .periodic = {0, 0, 1},
                                         .list = list,
                                         .fracture_energy = 0.05,
                                         .tensile_strength = softens ? strength : 0});
    s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->v[c][h] = 0.3 * noise(s, h, c);
    solid_ghosts_update(s);
    solid_breaks_begin(s);
    return s;
}

static void advance(struct solid *s, int from, int steps) {
    for (int k = from + 1; k <= from + steps; k++) {
        solid_integrate(s, step_of(0.1), 1);
        if (solid_breaks_is_due(s->breaks)) solid_breaks_stamp(s->breaks, k, 0.5 * k);
    }
}

/* Sums over all records are e_fracture and crack_area of the sweeps, with what softening bonds have released. */
static void sums(void **state) {
    (void)state;
    for (int kind = 0; kind < 8; kind++) {
        if (check_skips(kind ^ kind >> 1 ^ kind >> 2, 2)) continue; /* by day every pair of choices */
        struct solid *s = block(kind & 1, kind >> 1 & 1, kind >> 2);
        struct solid_break *bond;
        double energy = 0, area = 0, softening = 0, soft_energy = 0;
        advance(s, 0, 20);
        const long n = solid_events_take(s, &bond);
        solid_family_count(s);
        check_above(n, 100);
        check_equal(n, s->bonds_broken);
        for (long i = 0; i < n; i++) {
            double length = 0;
            energy += bond[i].energy;
            area += bond[i].area;
            for (int c = 0; c < 3; c++) length += bond[i].xi[c] * bond[i].xi[c];
            check_between(sqrt(length) / SPACING, 0.999, 3.5);
            check_between(bond[i].step, 0, 21);
            check_equal(bond[i].t, 0.5 * (double)bond[i].step);
            const int sense = bond[i].xi[0] != 0 ? bond[i].xi[0] > 0 : 1; /* from the end that comes first in x */
            check_equal(sense, 1);
            if (i == 0) continue;
            check_at_least(bond[i].step, bond[i - 1].step);
            check_equal(memcmp(bond[i].x, bond[i - 1].x, 2 * sizeof bond[i].x) != 0, 1);
        }
        for (int i = 0; s->soft && i < s->soft->n; i++) soft_energy += s->soft->bond[i].released;
        softening = par_sum(soft_energy);
        if (s->soft) check_above(softening, 0.1 * energy);
        check_relative(energy + softening, par_sum(s->e_fracture), 1e-12);
        check_relative(area, par_sum(s->crack_area), 1e-12);
        free(bond);
        check_equal(solid_events_take(s, &bond), 0);
        free(bond);
        solid_free(s);
    }
}

/* Read after steps 4 and 7; the state of step 2 restored after step 9, from which steps 3 to 11 are made again. The
 * lists are together those of a run that was never interrupted. */
static void restored(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        const int list = kind & 1, verlet = kind >> 1, softens = list ^ verlet;
        if (check_skips(verlet, 2)) continue;
        struct solid *s = block(list, verlet, softens), *whole = block(list, verlet, softens);
        struct solid_snapshot *keep = solid_snapshot_new(s, NULL, 1);
        struct solid_break *part[3], *all;
        advance(whole, 0, 11);
        const long n = solid_events_take(whole, &all);
        advance(s, 0, 2);
        solid_snapshot_take(keep, s, NULL);
        advance(s, 2, 2);
        const long first = solid_events_take(s, &part[0]);
        advance(s, 4, 3);
        const long second = solid_events_take(s, &part[1]);
        check_above(first, 0);
        check_above(second, 0);
        advance(s, 7, 2);
        check_above(par_sum_long(s->breaks->n), 0);
        solid_snapshot_restore(keep, s, NULL);
        check_equal(s->breaks->n, 0);
        advance(s, 2, 5);
        check_equal(s->breaks->n, 0);
        advance(s, 7, 4);
        const long third = solid_events_take(s, &part[2]);
        check_equal(first + second + third, n);
        assert_memory_equal(all, part[0], (size_t)first * sizeof *all);
        assert_memory_equal(all + first, part[1], (size_t)second * sizeof *all);
        assert_memory_equal(all + first + second, part[2], (size_t)third * sizeof *all);
        for (int k = 0; k < 3; k++) free(part[k]);
        free(all);
        solid_snapshot_free(keep);
        solid_free(whole);
        solid_free(s);
    }
}

/* Read after step 2, whose state is restored after step 9: fewer bonds break in step 3 than in those that are taken
 * back, and they get their step and time all the same. */
static void stamped_again(void **state) {
    (void)state;
    struct solid *s = block(0, 1, 0), *whole = block(0, 1, 0);
    struct solid_snapshot *keep = solid_snapshot_new(s, NULL, 1);
    struct solid_break *part[2], *all;
    advance(whole, 0, 9);
    const long n = solid_events_take(whole, &all);
    advance(s, 0, 2);
    const long first = solid_events_take(s, &part[0]);
    solid_snapshot_take(keep, s, NULL);
    advance(s, 2, 7);
    solid_snapshot_restore(keep, s, NULL);
    advance(s, 2, 7);
    const long second = solid_events_take(s, &part[1]);
    check_equal(first + second, n);
    assert_memory_equal(all, part[0], (size_t)first * sizeof *all);
    assert_memory_equal(all + first, part[1], (size_t)second * sizeof *all);
    check_equal(all[first].step, 3);
    for (int k = 0; k < 2; k++) free(part[k]);
    free(all);
    solid_snapshot_free(keep);
    solid_free(whole);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(sums), cmocka_unit_test(restored),
                                       cmocka_unit_test(stamped_again)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
