/* The field about a crack's tip. */
#include "physics/crack_tip.h"
#include "tests/check.h"

/* The field's stress follows from the displacement by Hooke's law, is in equilibrium and leaves the faces free. */
static void own_field(void **state) {
    (void)state;
    for (int strain = 0; strain < 2; strain++)
        for (int mode = 0; mode < 3; mode++) {
            const struct physics_crack_tip in = {7, 0.2, strain};
            const double r = 0.3, t = 0.8, step = 1e-5;
            double s[3], u[2], slope[2], side[2][3], at[2][2], unused[2];
            physics_crack_tip_field(&in, mode, r, t, s, u, slope);
            const double nu = strain ? 0.2 / 0.8 : 0.2, e = strain ? 7 / (1 - 0.04) : 7;
            check_close(slope[0], (s[0] - nu * s[1]) / e, 1e-12);
            /* equilibrium: s11,1 + s12,2 = 0 by central differences */
            double sum[2] = {0, 0}, shear = 0;
            for (int d = 0; d < 2; d++) {
                for (int k = 0; k < 2; k++) {
                    const double x = r * cos(t) + (d == 0 ? (k ? step : -step) : 0);
                    const double y = r * sin(t) + (d == 1 ? (k ? step : -step) : 0);
                    physics_crack_tip_field(&in, mode, hypot(x, y), atan2(y, x), side[k], at[k], unused);
                }
                const double rate[2] = {(at[1][0] - at[0][0]) / (2 * step), (at[1][1] - at[0][1]) / (2 * step)};
                for (int k = 0; k < 2 && d == 0; k++) check_close(rate[k], slope[k], 1e-8);
                if (d == 1) check_close(rate[1], (s[1] - nu * s[0]) / e, 1e-8);
                shear += d == 0 ? rate[1] : rate[0];
                sum[0] += (side[1][d ? 2 : 0] - side[0][d ? 2 : 0]) / (2 * step);
                sum[1] += (side[1][d ? 1 : 2] - side[0][d ? 1 : 2]) / (2 * step);
            }
            check_close(sum[0], 0, 1e-8);
            check_close(sum[1], 0, 1e-8);
            physics_crack_tip_field(&in, mode, r, acos(-1), side[0], u, slope);
            check_close(side[0][1], 0, 1e-15);
            check_close(side[0][2], 0, 1e-15);
            check_close(shear, s[2] * 2 * 1.2 / 7, 1e-8);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(own_field)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
