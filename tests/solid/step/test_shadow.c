/* What short waves hold beyond velocity Verlet's sums: by hand for a linear oscillator, in a block whose bonds are
 * stretched, and without a trace in the state. */
#include "solid/step/shadow.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/energy.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* Two particles along their bond are one linear mode: with x = omega dt/2 the scheme keeps
 *     I = m/2 v^2 + m/2 omega^2 (1 - x^2) d^2 ,
 * and short waves hold (asin(x)/(x sqrt(1 - x^2)) - 1) I, at any phase. */
static void oscillator(void **state) {
    (void)state;
    const double omega = sqrt(pair_stiffness()), size = 1e-3 * SPACING;
    for (int k = 0; k < 12; k++) {
        struct solid *s = pair_new(k % 2);
        const double x = 0.15 * (1 + k / 2), dt = 2 * x / omega,
                     mass = 0.5 * DENSITY * par_max(s->n > 0 ? s->volume[0] : 0);
        double d = size, v = 0.3 * omega * size;
        s->stage.integrator = SOLID_VERLET;
        pair_set(s, d, v);
        solid_ghosts_update(s);
        const double kept = 0.5 * mass * (v * v + omega * omega * (1 - x * x) * d * d),
                     held = (asin(x) / (x * sqrt(1 - x * x)) - 1) * kept;
        for (int n = 0; n < 5; n++) {
            check_relative(solid_shadow_waves(s, dt), held, 2e-3); /* as exact as second derivatives by differences */
            solid_integrate(s, dt, 1);
        }
        solid_free(s);
    }
}

enum kind { LATTICE, LIST, MIXED, KINDS };

/* Bent into half a wave: stretches up to `strain`. */
static struct solid *strained(enum kind kind, double strain) {
    struct solid *s = make((struct make){.sites = {8, 7, 6}, .list = kind == LIST, .mixed = kind == MIXED});
    s->stage.integrator = SOLID_VERLET;
    const double length = 8 * SPACING, number = acos(-1) / length;
    for (int h = 0; h < s->n; h++) s->d[0][h] = strain / number * sin(number * (s->x0[0][h] - 0.5 * length));
    solid_ghosts_update(s);
    return s;
}

/* The sums of velocity Verlet with what waves hold are constant where the sums alone are not. In mixed precision the
 * same. */
static void closes(void **state) {
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct solid *s = strained((enum kind)k, 0.15);
        const double dt = 0.5 * solid_rates_stable_step(s, SOLID_VERLET);
        double first = 0, first_all = 0, off = 0, off_all = 0;
        for (int n = 0; n < 60; n++) {
            solid_integrate(s, dt, 10);
            const struct solid_energy e = solid_energy_measure(s);
            const double sum = e.kinetic + e.strain + par_sum(s->e_integrator), all = sum + solid_shadow_waves(s, dt);
            if (n == 0) first = sum, first_all = all;
            off = fmax(off, fabs(sum / first - 1));
            off_all = fmax(off_all, fabs(all / first_all - 1));
        }
        print_message("kind %d: off by %.2g, with waves by %.2g\n", k, off, off_all);
        check_above(off, 5e-3);
        check_below(off_all, 5e-4);
        solid_free(s);
    }
}

/* The motion is the same to the bit whether it was asked for or not. */
static void leaves_no_trace(void **state) {
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct solid *s[2] = {strained((enum kind)k, 0.004), strained((enum kind)k, 0.004)};
        const double dt = 0.5 * solid_rates_stable_step(s[0], SOLID_VERLET);
        check_above(solid_rates_stable_step(s[1], SOLID_VERLET), dt);
        for (int n = 0; n < 20; n++) {
            for (int q = 0; q < 2; q++) solid_integrate(s[q], dt, 3);
            const long sweeps = s[1]->sweeps;
            check_above(solid_shadow_waves(s[1], dt), 0);
            check_equal(s[1]->sweeps, sweeps);
            for (int c = 0; c < 3; c++) {
                assert_memory_equal(s[0]->d[c], s[1]->d[c], (size_t)s[0]->n * sizeof(double));
                assert_memory_equal(s[0]->v[c], s[1]->v[c], (size_t)s[0]->n * sizeof(double));
                assert_memory_equal(s[0]->a[c], s[1]->a[c], (size_t)s[0]->n * sizeof(double));
            }
            check_equal(s[0]->power_damped, s[1]->power_damped);
        }
        for (int q = 0; q < 2; q++) solid_free(s[q]);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(oscillator), cmocka_unit_test(closes),
                                       cmocka_unit_test(leaves_no_trace)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
