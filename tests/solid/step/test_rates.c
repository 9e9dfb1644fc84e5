/* The largest rates of small bodies whose eigenvalues are known by hand. */
#include "solid/force/force.h"
#include "solid/step/rates.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* Two particles: one rate of the stiffness and one of the damping; the sum is at both their largest. */
static void pair_alone(void **state) {
    (void)state;
    const double w = pair_stiffness();
    for (int list = 0; list < 2; list++) {
        struct solid *s = pair_new(list);
        struct solid_rates rates;
        solid_rates_of(s, &rates);
        check_relative(rates.stiffness, w, 1e-6);
        check_equal(rates.damping, 0);
        check_equal(rates.sum, 1);
        check_equal(rates.difference, 1);
        check_relative(solid_rates_stable_step(s, SOLID_RK3), sqrt(3 / w), 1e-6);
        check_relative(solid_rates_stable_step(s, SOLID_VERLET), sqrt(4 / w), 1e-6);
        s->stage.damping_relative = pair_damping(123);
        s->stage.damping_absolute = 7;
        solid_rates_of(s, &rates);
        check_relative(rates.stiffness, w, 1e-6);
        check_relative(rates.damping, 123, 1e-6);
        check_relative(rates.sum, 2, 1e-6);
        check_close(rates.difference, 0, 1e-6);
        check_equal(rates.absolute, 7);
        solid_free(s);
    }
}

/* A chain of three. Along it the modes (1, -2, 1) and (1, 0, -1) have the rates 3 k and k + 2 k', k and k' the halves
 * of the near and the far bonds' rates; held at one end, the larger root of its 2 x 2 block. */
static void chain(void **state) {
    (void)state;
    const double k = 0.5 * pair_stiffness();
    const struct solid_constraint hold = {
        .low = {0, 0, 0}, .high = {SPACING, SPACING, SPACING}, .direction = {1, 1, 1}};
    for (int held = 0; held < 2; held++) {
        struct solid *s = make((struct make){
            .sites = {3, 1, 1}, .uncorrected = 1, .constraints = held, .constraint = held ? &hold : NULL});
        static struct solid_family_view view;
        struct solid_rates rates;
        double far = 0;
        solid_family_view(s, 0, &view);
        for (int b = 0; b < view.n; b++)
            if (fabs(view.xi[b][0]) > 1.5 * SPACING) far = 0.5 * k * view.weight[b] / (SPACING * SPACING * SPACING);
        check_between(far, 0.1 * k, 0.51 * k);
        solid_rates_of(s, &rates);
        /* {{2 k, -k}, {-k, k + far}} */
        const double middle = 0.5 * (3 * k + far), half = 0.5 * (k - far);
        check_relative(rates.stiffness, held ? middle + sqrt(half * half + k * k) : 3 * k, 1e-3);
        solid_free(s);
    }
}

/* The state is as before, also where bonds are broken; the rates are those of the unbroken body. */
static void state_untouched(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int list = 0; list < 2; list++) {
        struct solid *s = pair_new(list);
        struct solid_rates rates;
        s->stage.damping_relative = pair_damping(50);
        for (int h = 0; h < 2; h++)
            for (int c = 0; c < 3; c++) {
                s->d[c][h] = 1e-4 * SPACING * noise(s, h, c);
                s->v[c][h] = noise(s, h, c + 3);
            }
        solid_family_break(s, 0, 0);
        const long sweeps = s->sweeps;
        solid_rates_of(s, &rates);
        check_relative(rates.stiffness, pair_stiffness(), 1e-6);
        check_equal(s->sweeps, sweeps);
        for (int h = 0; h < 2; h++) {
            for (int c = 0; c < 3; c++) {
                check_equal(s->d[c][h], 1e-4 * SPACING * noise(s, h, c));
                check_equal(s->v[c][h], noise(s, h, c + 3));
            }
            solid_family_view(s, h, &view);
            check_equal(view.n, 1);
            check_equal(view.intact[0], 0);
        }
        solid_free(s);
    }
}

/* Rates found again are the same to the bit, whatever has been swept in between; and so is the next sweep, whether
 * rates were found or known. */
static void found_again(void **state) {
    (void)state;
    for (int mixed = 0; mixed < 2; mixed++) {
        struct solid *s = make((struct make){.sites = {9, 9, 9}, .mixed = mixed});
        struct solid_rates rates[2], known;
        double a[3];
        for (int k = 0; k < 2; k++) {
            for (int c = 0; c < 3; c++)
                for (int h = 0; h < s->n; h++) s->d[c][h] = 0.02 * SPACING * noise(s, h, c);
            for (int n = 0; n < 2; n++) solid_force(s, 0); /* with square roots from the second on */
            solid_rates_of(s, &rates[k]);
        }
        assert_memory_equal(&rates[0], &rates[1], sizeof rates[0]);
        solid_force(s, 0);
        for (int c = 0; c < 3; c++) a[c] = s->a[c][100];
        solid_force(s, 0);
        s->a_holds = 1;
        const struct solid_rates_found found = {1, s->stage.damping_relative, rates[0]};
        assert_true(solid_rates_again(s, &found, &known));
        assert_memory_equal(&rates[0], &known, sizeof known);
        check_equal(s->a_holds, 0);
        solid_force(s, 0);
        for (int c = 0; c < 3; c++) check_equal(s->a[c][100], a[c]);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pair_alone), cmocka_unit_test(chain),
                                       cmocka_unit_test(state_untouched), cmocka_unit_test(found_again)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
