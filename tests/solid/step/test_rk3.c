/* The Runge-Kutta substep: the exact amplification of an oscillator of two particles, and polynomial motion. */
#include "solid/bonds/ghosts.h"
#include "solid/step/rates.h"
#include "solid/step/rk3.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* (d, v)' = A (d, v) with A = {{0, 1}, {-w, -g}}: a step multiplies by I + z + z^2/2 + z^3/6, z = dt A. */
static void exact(double w, double g, double dt, double q[2]) {
    double term[2] = {q[0], q[1]};
    for (int k = 1; k <= 3; k++) {
        const double d = term[0], v = term[1];
        term[0] = dt / k * v;
        term[1] = dt / k * (-w * d - g * v);
        q[0] += term[0];
        q[1] += term[1];
    }
}

/* Undamped, with pairwise and with absolute damping, at small steps and near the limit sqrt(3) omega^-1. */
static void amplification(void **state) {
    (void)state;
    const double w = pair_stiffness(), omega = sqrt(w), size = 1e-3 * SPACING;
    for (int list = 0; list < 2; list++)
        for (int damped = 0; damped < 3; damped++)
            for (int k = 0; k < 3; k++) {
                struct solid *s = pair_new(list);
                const double dt = (0.05 + 0.8 * k) / omega, g = damped ? 0.3 * omega : 0;
                double q[2] = {size, 0.4 * omega * size}, d, v;
                if (damped == 1) s->stage.damping_relative = pair_damping(g);
                if (damped == 2) s->stage.damping_absolute = g;
                pair_set(s, q[0], q[1]);
                for (int n = 0; n < 5; n++) {
                    exact(w, g, dt, q);
                    solid_rk3_step(s, dt);
                    pair_get(s, &d, &v);
                    check_close(d, q[0], 1e-12 * size);
                    check_close(v, q[1], 1e-12 * size * omega);
                }
                check_equal(s->a_holds, 0);
                solid_free(s);
            }
}

/* Under a constant load d and its work are quadratic in time, v is linear: exact in a step of any length. */
static void falls(void **state) {
    (void)state;
    struct solid *s = pair_new(0);
    const double force = 7, dt = 0.3, a = force / DENSITY;
    for (int h = 0; h < 2; h++) s->load[1][h] = force;
    for (int n = 1; n <= 3; n++) {
        solid_rk3_step(s, dt);
        const double t = n * dt;
        for (int h = 0; h < 2; h++) {
            check_relative(s->d[1][h], 0.5 * a * t * t, 1e-13);
            check_relative(s->v[1][h], a * t, 1e-13);
        }
        check_relative(s->work_load, 2 * s->volume[0] * force * 0.5 * a * t * t, 1e-13);
    }
    solid_free(s);
}

/* What damping takes is what the oscillator loses, to the third order: eight times less error at half the step. */
static void energy_taken(void **state) {
    (void)state;
    const double w = pair_stiffness(), omega = sqrt(w), size = 1e-3 * SPACING;
    double error[2];
    for (int k = 0; k < 2; k++) {
        struct solid *s = pair_new(0);
        const int steps = 16 << k;
        double d, v;
        s->stage.damping_relative = pair_damping(0.4 * omega);
        pair_set(s, size, 0);
        for (int n = 0; n < steps; n++) solid_rk3_step(s, 2 / (omega * steps));
        pair_get(s, &d, &v);
        const double reduced = 0.5 * DENSITY * s->volume[0], before = 0.5 * reduced * w * size * size;
        const double after = 0.5 * reduced * (w * d * d + v * v);
        check_above(s->e_damped, 0.3 * before);
        error[k] = fabs(s->e_damped - (before - after)) / before;
        solid_free(s);
    }
    check_below(error[0], 1e-3);
    check_above(error[0] / error[1], 6);
}

/* All frequencies at once, at 0.3 to 0.9 of the limit: the kinetic and strain energy that is lost in 300 steps, and
 * what e_integrator says of it. Stretches of 1e-7: forces are linear. The part that grows as the sixth power of the
 * frequency is a mean over a period: it is off by some percent of the waves that are lost within one. */
static void loses(void **state) {
    (void)state;
    static const double part[] = {0.3, 0.6, 0.9}, off[] = {1e-3, 1e-2, 2e-2};
    for (int k = 0; k < 3; k++) {
        struct solid *s = make((struct make){.sites = {8, 9, 7}, .list = k == 1});
        const double dt = part[k] * solid_rates_stable_step(s, SOLID_RK3);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                s->d[c][h] = 1e-7 * SPACING * noise(s, h, c);
                s->v[c][h] = 1e-7 * sqrt(YOUNG / DENSITY) * noise(s, h, c + 5);
            }
        solid_ghosts_update(s);
        const double before = energy_of(s, NULL);
        for (int n = 0; n < 300; n++) solid_rk3_step(s, dt);
        solid_ghosts_update(s);
        const double lost = before - energy_of(s, NULL), said = par_sum(s->e_integrator);
        print_message("%.1f of the limit: lost %.3f of the energy, said %.3f\n", part[k], lost / before, said / before);
        check_above(lost, 0.05 * before);
        check_close(said, lost, off[k] * before);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(amplification), cmocka_unit_test(falls),
                                       cmocka_unit_test(energy_taken), cmocka_unit_test(loses)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
