/* Dispersion of plane waves, and the stable step by stepping beyond it. */
#include "base/step_status.h"
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "tests/check.h"

/* omega of a plane wave along x in units of sqrt(E/rho)/spacing, by projecting the force on it. */
static double omega(struct solid *s, int waves, int direction) {
    const double k = 2 * M_PI * waves / (40 * SPACING), amplitude = 1e-8 * SPACING;
    double sum[2] = {0};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = c == direction ? amplitude * cos(k * s->x0[0][h] + 0.3) : 0;
    solid_ghosts_update(s);
    solid_force(s, 0);
    for (int h = 0; h < s->n; h++) {
        sum[0] -= s->a[direction][h] * s->d[direction][h];
        sum[1] += s->d[direction][h] * s->d[direction][h];
    }
    par_sum_array(sum, 2);
    return sqrt(sum[0] / sum[1] / (YOUNG / DENSITY)) * SPACING;
}

static void test_dispersion(void **state) {
    (void)state;
    const int waves[9] = {1, 2, 4, 6, 8, 10, 12, 16, 20};
    const double longitudinal[9] = {.172999,  .341125,  .644758,  .881005, 1.033505,
                                    1.102373, 1.103324, 1.010403, .954998};
    const double transverse[9] = {.099498, .197327, .381681, .542044, .670947, .765425, .827164, .877415, .883340};
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {40, 4, 4}, .periodic = {1, 1, 1}, .list = list});
        for (int i = 0; i < 9; i++) {
            check_close(omega(s, waves[i], 0), longitudinal[i], 1e-5);
            check_close(omega(s, waves[i], 1), transverse[i], 1e-5);
            check_close(omega(s, waves[i], 2), transverse[i], 1e-5);
        }
        solid_free(s);
    }
}

static void test_stable_step(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {10, 10, 10}, .periodic = {1, 1, 1}, .list = list});
        for (int h = 0; h < s->n; h++) s->d[0][h] = h;
        check_close(solid_rates_stable_step(s, SOLID_RK3) / step_of(1.569), 1, 0.005);
        check_close(solid_rates_stable_step(s, SOLID_VERLET) / step_of(1.812), 1, 0.005);
        for (int h = 0; h < s->n; h++) check_equal(s->d[0][h], h); /* the state is left alone */
        solid_free(s);
    }
}

/* Held particles are no part of the motion; with all held there is no limit. */
static void test_stable_step_held(void **state) {
    (void)state;
    const struct solid_constraint all = {.low = {-1, -1, -1}, .high = {1, 1, 1}, .direction = {1, 1, 1}};
    struct solid *s = make((struct make){.sites = {8, 8, 8}, .constraints = 1, .constraint = &all});
    assert_true(isinf(solid_rates_stable_step(s, SOLID_RK3)));
    solid_free(s);
}

/* Growth of a noisy velocity over the steps. */
static double growth(enum solid_integrator integrator, double dt) {
    struct solid *s = make((struct make){.sites = {8, 8, 8}, .periodic = {1, 1, 1}});
    s->stage.integrator = integrator;
    double before = 0, after = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->v[c][h] = 1e-9 * noise(s, h, c);
            before = check_worst(before, s->v[c][h]);
        }
    solid_integrate(s, dt, 800);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) after = check_worst(after, s->v[c][h]);
    if (step_status_agree(&(struct step_status){.failed = solid_integrate_check(s).failed})) after = INFINITY;
    solid_free(s);
    return par_max(after) / par_max(before);
}

static void test_stability_by_stepping(void **state) {
    (void)state;
    check_below(growth(SOLID_RK3, step_of(1.569 * 0.98)), 3);
    check_above(growth(SOLID_RK3, step_of(1.569 * 1.02)), 100);
    check_below(growth(SOLID_VERLET, step_of(1.812 * 0.98)), 30); /* amplitudes of 1/sqrt(1 - (omega dt/2)^2) */
    check_above(growth(SOLID_VERLET, step_of(1.812 * 1.02)), 1e6);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dispersion),
        cmocka_unit_test(test_stable_step),
        cmocka_unit_test(test_stable_step_held),
        cmocka_unit_test(test_stability_by_stepping),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
