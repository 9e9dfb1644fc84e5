/* The Verlet substep: the exact amplification of an oscillator of two particles, time reversal, and the acceleration
 * that lasts to the next substep. */
#include "solid/step/verlet.h"
#include "tests/solid/step/oscillator.h"
#include "tests/check.h"

/* The step's formulas for a = -w d - pairwise v^ - absolute v*; q: d, v, a. */
static void exact(double w, double pairwise, double absolute, double dt, double q[3]) {
    const double early = q[1] + (pairwise > 0 ? SOLID_VERLET_PAIRWISE : 1) * dt * q[2], late = q[1] + dt * q[2];
    const double d = q[0] + dt * q[1] + 0.5 * dt * dt * q[2];
    const double a = -w * d - pairwise * early - absolute * late;
    q[0] = d;
    q[1] = late + 0.5 * dt * (a - q[2]);
    q[2] = a;
}

/* Undamped, with either damping and with both, at small steps and near the limit 2/omega. */
static void amplification(void **state) {
    (void)state;
    const double w = pair_stiffness(), omega = sqrt(w), size = 1e-3 * SPACING;
    for (int list = 0; list < 2; list++)
        for (int damped = 0; damped < 4; damped++)
            for (int k = 0; k < 3; k++) {
                struct solid *s = pair_new(list);
                const double dt = (0.05 + 0.9 * k) / omega;
                const double pairwise = damped & 1 ? 0.1 * omega : 0, absolute = damped & 2 ? 0.07 * omega : 0;
                double q[3] = {size, 0.4 * omega * size}, d, v;
                s->stage.integrator = SOLID_VERLET;
                s->stage.damping_relative = pair_damping(pairwise);
                s->stage.damping_absolute = absolute;
                pair_set(s, q[0], q[1]);
                q[2] = -w * q[0] - (pairwise + absolute) * q[1];
                solid_verlet_begin(s);
                for (int n = 0; n < 5; n++) {
                    exact(w, pairwise, absolute, dt, q);
                    solid_verlet_step(s, dt);
                    pair_get(s, &d, &v);
                    check_close(d, q[0], 1e-12 * size);
                    check_close(v, q[1], 1e-12 * size * omega);
                }
                solid_verlet_end(s);
                solid_free(s);
            }
}

/* With the speed reversed the way back leads to the start; within the limit the shadow energy is constant,
 * (1 - w dt^2/4) w d^2 + v^2. */
static void reversible(void **state) {
    (void)state;
    const double w = pair_stiffness(), omega = sqrt(w), size = 1e-2 * SPACING, dt = 1.9 / omega;
    struct solid *s = pair_new(0);
    double d, v;
    pair_set(s, size, 0);
    const double before = (1 - 0.25 * w * dt * dt) * w * size * size;
    for (int way = 0; way < 2; way++) {
        solid_verlet_begin(s);
        for (int n = 0; n < 40; n++) {
            solid_verlet_step(s, dt);
            pair_get(s, &d, &v);
            check_relative((1 - 0.25 * w * dt * dt) * w * d * d + v * v, before, 1e-10);
        }
        solid_verlet_end(s);
        pair_set(s, d, -v);
    }
    check_close(d, size, 1e-10 * size);
    check_close(v, 0, 1e-10 * size * omega);
    solid_free(s);
}

/* The work of the load follows from the displacement: exact under a constant load, in a step of any length. */
static void falls(void **state) {
    (void)state;
    struct solid *s = pair_new(0);
    const double force = 7, dt = 0.3, a = force / DENSITY;
    for (int h = 0; h < 2; h++) s->load[1][h] = force;
    solid_verlet_begin(s);
    for (int n = 1; n <= 3; n++) {
        solid_verlet_step(s, dt);
        const double t = n * dt;
        for (int h = 0; h < 2; h++) {
            check_relative(s->d[1][h], 0.5 * a * t * t, 1e-13);
            check_relative(s->v[1][h], a * t, 1e-13);
        }
        check_relative(s->work_load, 2 * s->volume[0] * force * 0.5 * a * t * t, 1e-13);
    }
    solid_free(s);
}

/* After an end a second begin takes no sweep, but finds the acceleration of a changed load; a changed stage, or one
 * that no longer holds, takes one. */
static void lasts(void **state) {
    (void)state;
    const double w = pair_stiffness(), size = 1e-3 * SPACING;
    struct solid *s = pair_new(0);
    s->stage.integrator = SOLID_VERLET;
    pair_set(s, size, 0);
    const int r = pair_right(s);
    solid_verlet_begin(s);
    check_relative(s->a[0][r], -0.5 * w * size, 1e-12);
    solid_verlet_end(s);
    check_equal(s->a_holds, 1);
    const long sweeps = s->sweeps;
    s->load[0][r] = 3 * DENSITY;
    solid_verlet_begin(s);
    check_equal(s->sweeps, sweeps);
    check_relative(s->a[0][r], -0.5 * w * size + 3, 1e-12);
    s->stage.damping_absolute = 1;
    solid_verlet_begin(s);
    check_equal(s->sweeps, sweeps + 1);
    solid_verlet_end(s);
    pair_set(s, 2 * size, 0);
    solid_verlet_begin(s);
    check_equal(s->sweeps, sweeps + 2);
    check_relative(s->a[0][r], -w * size + 3, 1e-12);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(amplification), cmocka_unit_test(reversible),
                                       cmocka_unit_test(falls), cmocka_unit_test(lasts)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
