/* The kink angle and K_eq by the maximum hoop stress. */
#include "physics/kink.h"
#include "physics/crack_tip.h"
#include "tests/check.h"

/* Pure modes: straight ahead; 70.53 degrees away from the sense of K_II, where K_eq is 2/sqrt(3) K_II. */
static void pure(void **state) {
    (void)state;
    check_close(physics_kink_angle((const double[2]){3, 0}), 0, 1e-15);
    check_relative(physics_kink_equivalent((const double[2]){3, 0}), 3, 1e-15);
    check_close(physics_kink_angle((const double[2]){0, 0}), 0, 1e-15);
    for (int sign = -1; sign < 2; sign += 2) {
        const double k[2] = {0, 2. * sign};
        check_relative(physics_kink_angle(k), -sign * acos(1. / 3), 1e-14);
        check_relative(physics_kink_equivalent(k), 2 * 2 / sqrt(3), 1e-14);
    }
    check_relative(physics_kink_angle((const double[2]){1, 1e-9}), -2e-9, 1e-9); /* -2 K_II/K_I, without cancellation */
}

/* Of the crack's own field no direction has a larger hoop stress, and K_eq is that stress. */
static void largest(void **state) {
    (void)state;
    const struct physics_crack_tip in = {1, 0.3, 0};
    const double r = 0.01, mixes[5][2] = {{1, 0.2}, {1, -1}, {0.3, 2}, {-0.2, 1}, {-0.5, -0.4}};
    for (int i = 0; i < 5; i++) {
        double most = -INFINITY, at = 0;
        for (int n = -31000; n <= 31000; n++) {
            const double t = 1e-4 * n, c = cos(t), s = sin(t);
            double sum = 0;
            for (int m = 0; m < 2; m++) {
                double stress[3], u[2], slope[2];
                physics_crack_tip_field(&in, m, r, t, stress, u, slope);
                sum += mixes[i][m] * (stress[0] * s * s + stress[1] * c * c - 2 * stress[2] * s * c);
            }
            if (sum > most) most = sum, at = t;
        }
        check_close(physics_kink_angle(mixes[i]), at, 1e-4);
        check_relative(physics_kink_equivalent(mixes[i]), most * sqrt(2 * M_PI * r), 1e-7);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pure), cmocka_unit_test(largest)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
