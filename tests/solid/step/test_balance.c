/* The balance of energy with velocity Verlet, exact where forces are linear in the displacement: with damped pairs,
 * bonds that break, driven layers and loads; and what a change of the stage leaves of it. */
#include "solid/bonds/ghosts.h"
#include "solid/measure/energy.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"
#include "solid/step/verlet.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* Stretches of 1e-7: forces are linear to 1e-7, and so is the balance. In mixed precision forces are rounded to 6e-8,
 * which changes the energy by 6e-6 in the 71 steps here, with and without damping. */
static const double STRAIN = 1e-7, LINEAR = 1e-6, LINEAR_MIXED = 2e-5;

/* A fracture energy at which noise of STRAIN breaks a part of the bonds. */
static const double FRAGILE = 1e-8;

enum kind { LATTICE, LIST, MIXED, KINDS };

static struct solid *block(enum kind kind, double fracture_energy, double damping) {
    static const struct solid_constraint constraint[2] = {
        {.low = {-1, -1, -1}, .high = {1, 2.5e-3, 1}, .direction = {1, 1, 1}},
        {.low = {-1, 14e-3, -1}, .high = {1, 1, 1}, .direction = {0, 1, 0}, .velocity = {0, 1e-5, 0}}};
    struct solid *s = make((struct make){.sites = {9, 12, 10},
                                         .periodic = {0, 0, 1},
                                         .list = kind == LIST,
                                         .mixed = kind == MIXED,
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .fracture_energy = fracture_energy,
                                         .body_force = {0, 0, -2}});
    s->stage =
        (struct solid_stage){.integrator = SOLID_VERLET, .breakage = fracture_energy > 0, .damping_relative = damping};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            if (s->flag[h] & SOLID_HELD_X << c) continue;
            s->d[c][h] = STRAIN * SPACING * noise(s, h, c);
            s->v[c][h] = STRAIN * sqrt(YOUNG / DENSITY) * noise(s, h, c + 5);
        }
    solid_ghosts_update(s);
    return s;
}

/* What is constant: all energies, the integrator's included, less the works. */
static double constant_of(struct solid *s) {
    const struct solid_energy e = solid_energy_measure(s);
    return e.kinetic + e.strain + e.damped + e.fracture + par_sum(s->e_integrator - s->work_load - s->e_constraint);
}

/* Steps at 0.8 of the stable one. Without damping this does not contain the pairs' work, so e_fracture is tested by
 * itself; with damping that of a rate of 1e-30, e_damped is nothing but the difference of the pairs' work from strain
 * energy and e_fracture. */
static void closes(void **state) {
    (void)state;
    const double none = 0, least = 1e-17, some = 4e13, damping[3] = {none, least, some};
    for (int k = 0; k < 18; k++) {
        const enum kind kind = (enum kind)(k % KINDS);
        const int breaks = k / KINDS % 2, damped = k / KINDS / 2;
        if (check_skips(k + damped, 2)) continue;
        struct solid *s = block(kind, breaks ? FRAGILE : 0, damping[damped]);
        const double tolerance = kind == MIXED ? LINEAR_MIXED : LINEAR, dt = step_of(0.45);
        const double size = solid_energy_measure(s).strain;
        solid_integrate(s, dt, 1);
        const double start = constant_of(s);
        double last = solid_energy_measure(s).damped, fell = 0;
        for (int i = 0; i < 10; i++) {
            solid_integrate(s, dt, 7);
            const double now = solid_energy_measure(s).damped;
            fell = fmax(fell, last - now);
            last = now;
        }
        solid_family_count(s);
        const struct solid_energy e = solid_energy_measure(s);
        print_message("kind %d, breaks %d, damped %d: drift %.2g, damped %.2g, fracture %.2g, broken %ld of %ld\n",
                      (int)kind, breaks, damped, (constant_of(s) - start) / size, e.damped / size, e.fracture / size,
                      s->bonds_broken, s->bonds_total);
        check_close(constant_of(s), start, tolerance * size);
        check_at_most(fell, tolerance * size);
        if (damping[damped] == none) check_equal(e.damped, 0);
        if (damping[damped] == least) check_close(e.damped, 0, tolerance * size);
        if (damping[damped] == some) check_above(e.damped, 0.1 * size);
        check_equal(s->bonds_broken > s->bonds_total / 100, breaks);
        check_below(s->bonds_broken, 0.8 * s->bonds_total);
        if (breaks) check_above(e.fracture, 0.01 * size);
        solid_free(s);
    }
}

/* Absolute damping at 0.9 of the stable step: with damped_missed the balance closes as without damping, and without it
 * it is off by percents. The second half has a new beginning of the substeps each time. */
static void absolute(void **state) {
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct solid *s = block((enum kind)k, 0, 0);
        const double rate = 0.2 * sqrt(YOUNG / DENSITY) / SPACING, tolerance = k == MIXED ? LINEAR_MIXED : LINEAR;
        s->stage.damping_absolute = rate;
        const double size = solid_energy_measure(s).strain, dt = 0.9 * solid_rates_stable_step(s, SOLID_VERLET);
        solid_integrate(s, dt, 1);
        const double start = constant_of(s) + par_sum(s->damped_missed), without = constant_of(s);
        for (int i = 0; i < 20; i++) {
            solid_integrate(s, dt, i < 10 ? 7 : 1);
            check_close(constant_of(s) + par_sum(s->damped_missed), start, tolerance * size);
        }
        print_message("kind %d: e_damped is off by %.2g of the energy\n", k, (constant_of(s) - without) / size);
        check_above(constant_of(s) - without, 0.03 * size);
        solid_free(s);
    }
}

/* Two particles by hand: with d, v, a of the distance and the reduced mass, the damping's work in a substep is that of
 * the mean of its forces at both ends, each by the velocity it is computed with. */
static void oscillator(void **state) {
    (void)state;
    const double w = pair_stiffness(), omega = sqrt(w), rate = 0.2 * omega, size = 1e-3 * SPACING;
    for (int k = 0; k < 3; k++) {
        struct solid *s = pair_new(0);
        const double dt = (0.05 + 0.8 * k) / omega, reduced = 0.5 * DENSITY * s->volume[0];
        double d = size, v = 0.4 * omega * size, force = -rate * v, a = -w * d + force, taken = 0;
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_relative = pair_damping(rate)};
        pair_set(s, d, v);
        for (int n = 0; n < 6; n++) {
            const double way = dt * v + 0.5 * dt * dt * a, late = -rate * (v + SOLID_VERLET_PAIRWISE * dt * a);
            const double next = -w * (d + way) + late;
            taken -= 0.5 * reduced * (force + late) * way;
            d += way;
            v += 0.5 * dt * (a + next);
            a = next;
            force = late;
            solid_integrate(s, dt, 1);
            check_relative(solid_energy_measure(s).damped, taken, 1e-11);
        }
        solid_free(s);
    }
}

/* What damping takes of a strained block in a given time, over its energy at the start. */
static double taken(enum solid_integrator integrator, int steps) {
    struct solid *s = block(LATTICE, 0, 4e13);
    s->stage.integrator = integrator;
    const struct solid_energy before = solid_energy_measure(s);
    solid_integrate(s, step_of(9.) / steps, steps);
    const double share = solid_energy_measure(s).damped / (before.kinetic + before.strain);
    solid_free(s);
    return share;
}

/* RK3 integrates the damping's power. Verlet's motion is of first order with damped pairs, and so is what they take. */
static void as_rk3(void **state) {
    (void)state;
    const double exact = taken(SOLID_RK3, 320);
    double error[3];
    for (int k = 0; k < 3; k++) error[k] = fabs(taken(SOLID_VERLET, 20 << k) / exact - 1);
    print_message("taken by damping: %.4g; error %.2g %.2g %.2g\n", exact, error[0], error[1], error[2]);
    check_above(exact, 0.1);
    check_below(error[0], 0.05);
    check_below(error[1], 0.6 * error[0]);
    check_below(error[2], 0.6 * error[1]);
}

/* What was dissipated stays the same when another integrator, no damping or a relaxation follows; then it grows on. */
static void turns(void **state) {
    (void)state;
    struct solid *s = block(LIST, 0, 4e13);
    const double dt = step_of(0.2), size = solid_energy_measure(s).strain;
    solid_integrate(s, dt, 20);
    const double first = solid_energy_measure(s).damped;
    check_equal(s->balance, SOLID_BALANCE_BONDS);
    s->stage.damping_relative = 0;
    solid_integrate(s, dt, 10);
    check_equal(s->balance, SOLID_BALANCE_NONE);
    check_close(solid_energy_measure(s).damped, first, 1e-12 * size);
    s->stage.damping_relative = 4e13;
    solid_integrate(s, dt, 10);
    const double second = solid_energy_measure(s).damped;
    check_above(second, first + 0.01 * size);
    (void)solid_relax(s, 1e-3, 50);
    check_equal(s->balance, SOLID_BALANCE_NONE);
    check_close(solid_energy_measure(s).damped, second, 1e-12 * size);
    s->stage.integrator = SOLID_RK3;
    solid_integrate(s, dt, 1);
    check_at_least(solid_energy_measure(s).damped, second * (1 - 1e-12));
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(closes), cmocka_unit_test(absolute),
                                       cmocka_unit_test(oscillator), cmocka_unit_test(as_rk3), cmocka_unit_test(turns)};
    const struct CMUnitTest on_ranks[] = {cmocka_unit_test(closes), cmocka_unit_test(as_rk3), cmocka_unit_test(turns)};
    const int failed =
        par_size() == 1 ? cmocka_run_group_tests(tests, NULL, NULL) : cmocka_run_group_tests(on_ranks, NULL, NULL);
    par_end();
    return failed;
}
