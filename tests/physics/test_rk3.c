/* The Runge-Kutta coefficients: conditions of order, and the stability limits that the solvers use. */
#include "physics/rk3.h"

#include <complex.h>
#include <stddef.h>
#include "tests/check.h"

/* Each stage lasts gamma = alpha + beta; together they last one step. */
static void stages(void **state) {
    (void)state;
    double sum = 0;
    for (int r = 0; r < 3; r++) {
        check_close(physics_rk3_alpha[r] + physics_rk3_beta[r], physics_rk3_gamma[r], 1e-15);
        sum += physics_rk3_gamma[r];
    }
    check_close(sum, 1, 1e-15);
    assert_true(physics_rk3_beta[0] == 0); /* the first stage reads nothing of the step before */
}

static double complex amplification(double complex z) {
    double complex q = 1, old = 0;
    for (int r = 0; r < 3; r++) {
        const double complex rate = z * q;
        q += physics_rk3_alpha[r] * rate + physics_rk3_beta[r] * old;
        old = rate;
    }
    return q;
}

/* Third order: one step of dq/dt = z q is 1 + z + z^2/2 + z^3/6, and oscillations are stable up to |z| = sqrt(3). */
static void order(void **state) {
    (void)state;
    for (int i = 0; i < 20; i++) {
        const double complex z = 2 * cexp(0.4 * i * I), series = 1 + z + z * z / 2 + z * z * z / 6;
        check_close(cabs(amplification(z) - series), 0, 1e-14);
    }
    assert_true(cabs(amplification(0.999 * sqrt(3) * I)) < 1);
    assert_true(cabs(amplification(1.001 * sqrt(3) * I)) > 1);
}

/* The means of time and of its square over the stages are those of a step, where the rate depends on time alone: third
 * order in a quadrature as well. */
static void quadrature(void **state) {
    (void)state;
    double t = 0, q[3] = {0}, old[3] = {0};
    for (int r = 0; r < 3; r++) {
        for (int power = 0; power < 3; power++) {
            const double rate = pow(t, power);
            q[power] += physics_rk3_alpha[r] * rate + physics_rk3_beta[r] * old[power];
            old[power] = rate;
        }
        t += physics_rk3_gamma[r];
    }
    for (int power = 0; power < 3; power++) check_close(q[power], 1. / (power + 1), 1e-15);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stages),
        cmocka_unit_test(order),
        cmocka_unit_test(quadrature),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
