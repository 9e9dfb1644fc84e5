/* Damping dissipates energy, and the energy budget closes with all sources and sinks. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

static const double PAIRWISE = 2e13,
                    ABSOLUTE = 1e3; /* k_d, k_a: a few percent of critical at the lattice's frequency */

static void shake(struct solid *s, double strain, double speed) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            const double x = s->x0[(c + 1) % 3][h] / SPACING;
            if (s->flag[h] & SOLID_HELD_X << c) continue;
            s->d[c][h] = strain * SPACING * sin(0.7 * x + c);
            s->v[c][h] = speed * cos(0.9 * x - c);
        }
}

/* At each sweep power_damped is not negative, and it is minus the work of the damping force. */
static void test_takes_energy(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++) {
        struct solid *damped = make((struct make){.sites = {9, 8, 10}, .list = list});
        struct solid *free = make((struct make){.sites = {9, 8, 10}, .list = list});
        damped->stage.damping_relative = PAIRWISE;
        for (int h = 0; h < free->n; h++)
            for (int c = 0; c < 3; c++) {
                damped->d[c][h] = free->d[c][h] = 0.02 * SPACING * noise(free, h, c);
                damped->v[c][h] = noise(free, h, c + 5);
            }
        solid_ghosts_update(damped);
        solid_ghosts_update(free);
        solid_force(damped, 0);
        solid_force(free, 0);
        double work = 0, total[3] = {0}, size = 0;
        for (int h = 0; h < free->n; h++)
            for (int c = 0; c < 3; c++) {
                const double force = DENSITY * free->volume[h] * (damped->a[c][h] - free->a[c][h]);
                work += force * damped->v[c][h];
                total[c] += force;
                size += fabs(force);
            }
        check_above(par_sum(damped->power_damped), 0);
        check_close(par_sum(work) / par_sum(damped->power_damped), -1, 1e-10);
        par_sum_array(total, 3);
        size = par_sum(size);
        for (int c = 0; c < 3; c++) check_close(total[c] / size, 0, 1e-14);
        /* a rigid motion is not damped: translation and spin */
        for (int h = 0; h < free->n; h++)
            for (int c = 0; c < 3; c++) {
                const int d = (c + 1) % 3, e = (c + 2) % 3;
                damped->d[c][h] = 0;
                damped->v[c][h] = 3 + c + (e + 1) * damped->x0[d][h] / SPACING - (d + 1) * damped->x0[e][h] / SPACING;
            }
        solid_ghosts_update(damped);
        solid_force(damped, 0);
        for (int h = 0; h < free->n; h++)
            for (int c = 0; c < 3; c++) check_close(damped->a[c][h] * DENSITY / (PAIRWISE * 4e-7), 0, 1e-11);
        solid_free(damped);
        solid_free(free);
    }
}

/* A uniform motion decays as exp(-k_a t): errors of the velocity and of the energy taken out. */
static void decay(int verlet, int steps, double error[2]) {
    struct solid *s = make((struct make){.sites = {8, 8, 8}, .periodic = {1, 1, 1}});
    s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .damping_absolute = ABSOLUTE};
    for (int h = 0; h < s->n; h++) s->v[1][h] = 2;
    const double time = step_of(40), kinetic = 0.5 * DENSITY * 512 * pow(SPACING, 3) * 4;
    solid_integrate(s, time / steps, steps);
    error[0] = fabs((s->n > 0 ? s->v[1][0] : 0) / (2 * exp(-ABSOLUTE * time)) - 1);
    error[1] = fabs(par_sum(s->e_damped) / (kinetic * (1 - exp(-2 * ABSOLUTE * time))) - 1);
    solid_free(s);
}

static void test_decay(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++) {
        double coarse[2], fine[2];
        decay(verlet, 25, coarse);
        decay(verlet, 50, fine);
        for (int i = 0; i < 2; i++) {
            check_close(log2(coarse[i] / fine[i]), verlet ? 2 : 3, 0.15);
            check_below(fine[i], verlet ? 1e-4 : 1e-6);
        }
    }
}

/* Residual of e_kinetic + e_strain + e_damped + e_fracture = work_load + e_constraint, over its largest term. */
static double imbalance(int verlet, int list, int steps, double fracture_energy, int *broke) {
    const struct solid_constraint constraint[2] = {
        {.low = {-1, -1, -1}, .high = {1, 3 * SPACING, 1}, .direction = {1, 1, 1}},
        {.low = {-1, 9 * SPACING, -1}, .high = {1, 1, 1}, .direction = {0, 1, 1}, .velocity = {0, 0.02, -0.01}}};
    struct solid *s = make((struct make){.sites = {8, 12, 7},
                                         .list = list,
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .fracture_energy = fracture_energy,
                                         .body_force = {0, 0, -200}});
    s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
    s->stage.damping_relative = PAIRWISE;
    s->stage.damping_absolute = ABSOLUTE;
    shake(s, 2e-5, 1e-3);
    solid_ghosts_update(s);
    const double e0 = energy_of(s, NULL);
    const int parts = 5;
    for (int i = 0; i < parts; i++) {
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->load[c][h] = (2 + i) * 1e5 * cos(s->x0[c][h] / SPACING + c);
        solid_integrate(s, step_of(50.) / steps, steps / parts);
    }
    solid_ghosts_update(s);
    const double e1 = energy_of(s, NULL);
    double sum[4] = {0, s->e_fracture, s->work_load, s->e_constraint};
    par_sum_array(sum, 4);
    sum[0] = solid_energy_measure(s).damped;
    solid_family_count(s);
    *broke = s->bonds_broken > 0;
    check_above(sum[0], 0.05 * sum[2]);
    check_above(sum[2], 0);
    check_above(fabs(sum[3]), 0.01 * sum[2]);
    if (*broke) check_above(sum[1], 0.001 * sum[2]);
    solid_free(s);
    return fabs(e1 - e0 + sum[0] + sum[1] - sum[2] - sum[3]) / sum[2];
}

static void test_budget(void **state) {
    (void)state;
    int broke;
    for (int list = 0; list < 2; list++)
        for (int verlet = 0; verlet < 2; verlet++) {
            if (check_skips(list ^ verlet, 2)) continue;
            const double coarse = imbalance(verlet, list, 200, 0, &broke),
                         fine = imbalance(verlet, list, 400, 0, &broke);
            assert_int_equal(broke, 0);
            check_below(coarse, verlet ? 1e-2 : 1e-3);
            check_close(log2(coarse / fine), verlet ? 2 : 3, 0.3);
            /* with bonds breaking the state is rougher, and the budget still closes */
            check_below(imbalance(verlet, list, 400, 2e-4, &broke), verlet ? 2e-3 : 2e-4);
            assert_int_equal(broke, 1);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_takes_energy),
        cmocka_unit_test(test_decay),
        cmocka_unit_test(test_budget),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
