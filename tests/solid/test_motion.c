/* A free body conserves momentum and energy. */
#include "base/step_status.h"
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"
#include "tests/solid/totals.h"

static void test_pair_forces(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++)
        for (int large = 0; large < 2; large++) {
            struct solid *s = make((struct make){.sites = {9, 10, 11}, .list = list});
            s->stage.damping_relative = 1e14;
            shake(s, large ? 0.05 : 1e-4, 1e-3);
            solid_ghosts_update(s);
            solid_force(s, 0);
            double total[6], size;
            totals(s, 1, total, &size);
            for (int c = 0; c < 6; c++) check_close(total[c] / size, 0, 1e-14);
            solid_free(s);
        }
}

static void test_momentum(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++)
        for (int verlet = 0; verlet < 2; verlet++) {
            struct solid *s = make((struct make){.sites = {9, 8, 7}, .list = list});
            s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
            shake(s, 1e-3, 1e-3);
            solid_ghosts_update(s);
            double before[6], after[6], size;
            totals(s, 0, before, &size);
            solid_integrate(s, step_of(0.5), 20);
            totals(s, 0, after, &size);
            for (int c = 0; c < 3; c++) check_close((after[c] - before[c]) / size, 0, 1e-14);
            /* Verlet keeps angular momentum to round-off, Runge-Kutta to its order, times the strain squared */
            for (int c = 3; c < 6; c++) check_close((after[c] - before[c]) / size, 0, verlet ? 1e-14 : 1e-5);
            solid_free(s);
        }
}

/* The change of energy in a standing wave over a given time: largest on the way (Verlet), at the end (RK3). */
static double drift(int verlet, int steps) {
    struct solid *s = make((struct make){.sites = {10, 4, 4}, .periodic = {1, 1, 1}});
    s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++)
            s->d[c][h] = 1e-5 * SPACING * cos(2 * M_PI * (c + 1) * s->x0[0][h] / (10 * SPACING));
    solid_ghosts_update(s);
    const double e0 = energy_of(s, NULL);
    double most = 0;
    for (int i = 0; i < steps; i++) {
        solid_integrate(s, step_of(24.) / steps, 1);
        solid_ghosts_update(s);
        const double change = fabs(energy_of(s, NULL) / e0 - 1);
        most = verlet ? fmax(most, change) : change;
    }
    solid_free(s);
    return most;
}

static void test_energy_order(void **state) {
    (void)state;
    const double rk3 = log2(drift(0, 60) / drift(0, 120)), verlet = log2(drift(1, 60) / drift(1, 120));
    check_close(rk3, 3, 0.15);
    check_close(verlet, 2, 0.15);
}

/* A step that starts from the acceleration kept, with a new load, is the step that starts afresh. */
static void test_verlet_keeps(void **state) {
    (void)state;
    struct solid *kept = make((struct make){.sites = {9, 8, 7}}), *fresh = make((struct make){.sites = {9, 8, 7}});
    for (int i = 0; i < 4; i++) {
        struct solid *const both[2] = {kept, fresh};
        for (int k = 0; k < 2; k++) {
            struct solid *s = both[k];
            if (i == 0) shake(s, 1e-4, 1e-3);
            s->stage.integrator = SOLID_VERLET;
            for (int h = 0; h < s->n; h++) s->load[1][h] = 1e3 * i * noise(s, h, 9);
            if (k == 1) s->a_holds = 0;
            solid_integrate(s, step_of(1), 3);
        }
    }
    assert_int_equal(kept->sweeps, 1 + 4 * 3);
    assert_int_equal(fresh->sweeps, 4 * 4);
    for (int h = 0; h < kept->n; h++)
        for (int c = 0; c < 3; c++) check_close((kept->d[c][h] - fresh->d[c][h]) / SPACING, 0, 1e-15);
    check_close(par_sum(kept->work_load) / par_sum(fresh->work_load), 1, 1e-12);
    solid_free(kept);
    solid_free(fresh);
}

/* The force sweeps of a substep, as many as the integrator's line in the table says. */
static void test_sweeps(void **state) {
    (void)state;
    for (int k = 0; k < SOLID_INTEGRATORS; k++) {
        struct solid *s = make((struct make){.sites = {9, 8, 7}});
        s->stage.integrator = (enum solid_integrator)k;
        shake(s, 1e-4, 1e-3);
        solid_integrate(s, step_of(0.5), 1);
        const long before = s->sweeps; /* Verlet's first acceleration takes one more */
        solid_integrate(s, step_of(0.5), 4);
        assert_int_equal(s->sweeps - before, solid_integrate_sweeps(s, 4));
        assert_int_equal(solid_integrate_sweeps(s, 4), k == SOLID_RK3 ? 12 : 4);
        solid_free(s);
    }
}

/* A particle that is nowhere is found, with its place. */
static void test_check(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {9, 8, 7}});
    assert_int_equal(solid_integrate_check(s).failed, 0);
    if (s->n > 3) {
        s->v[1][3] = NAN;
        const struct step_status status = solid_integrate_check(s);
        assert_int_equal(status.failed, 1);
        assert_int_equal(status.rank, par_rank());
        assert_int_equal(status.seen_in, STEP_STATUS_SOLID);
        assert_string_equal(status.field, "solid velocity");
        for (int c = 0; c < 3; c++) check_equal(status.x[c], s->x0[c][3]);
    }
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pair_forces),  cmocka_unit_test(test_momentum), cmocka_unit_test(test_energy_order),
        cmocka_unit_test(test_verlet_keeps), cmocka_unit_test(test_sweeps),   cmocka_unit_test(test_check),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
