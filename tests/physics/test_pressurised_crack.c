/* Cracks and a hole under pressure at nu = 1/4: the printed factors, and Irwin's relation. */
#include "tests/physics/pressurised_crack.h"
#include "base/par.h"
#include "physics/crack_tip.h"
#include "tests/check.h"

static const double NU = 0.25;

static double modulus_of(double e) {
    const struct physics_crack_tip in = {e, NU, 1};
    return physics_crack_tip_modulus(&in);
}

static void printed(void **state) {
    (void)state;
    const double e = 7e9, p = 3e5, a = 0.4, modulus = modulus_of(e);
    const struct {
        enum crack_shape shape;
        double opening, volume, critical;
    } row[] = {{CRACK_PLANE, 3.75, 5.8905, 0.58269}, {CRACK_PENNY, 2.3873, 5.0000, 0.91529}};
    for (int i = 0; i < 2; i++) {
        const enum crack_shape shape = row[i].shape;
        const double size = i == 0 ? a * a : a * a * a;
        check_close(pressurised_crack_opening(shape, modulus, p, a, 0) * e / (p * a), row[i].opening, 5e-5);
        check_close(pressurised_crack_volume(shape, modulus, p, a) * e / (p * size), row[i].volume, 5e-5);
        check_close(pressurised_crack_critical(shape, modulus, 12, a) / sqrt(e * 12 / a), row[i].critical, 5e-6);
    }
    check_relative(pressurised_crack_hole(e, NU, p, a), 1.25 * p * a / e, 1e-14);
}

/* The volume is the integral of the opening; and the energy that a longer crack releases at constant pressure, half of
 * p dV, is K_I^2/E' times the new area. */
static void consistent(void **state) {
    (void)state;
    enum { PARTS = 4000 };
    const double modulus = modulus_of(7e9), p = 3e5, a = 0.4, pi = acos(-1);
    for (int i = 0; i < 2; i++) {
        const enum crack_shape shape = i == 0 ? CRACK_PLANE : CRACK_PENNY;
        double volume = 0;
        for (int k = 0; k < PARTS; k++) { /* x = a sin(b) */
            const double b = 0.5 * pi * (k + 0.5) / PARTS, x = a * sin(b), dx = a * cos(b) * 0.5 * pi / PARTS;
            volume += pressurised_crack_opening(shape, modulus, p, a, x) * dx * (i == 0 ? 2 : 2 * pi * x);
        }
        check_relative(pressurised_crack_volume(shape, modulus, p, a), volume, 1e-6);
        check_equal(pressurised_crack_opening(shape, modulus, p, a, 1.01 * a), 0);
        const double step = 1e-5 * a, area = i == 0 ? 4 * step : 4 * pi * a * step;
        const double grown = pressurised_crack_volume(shape, modulus, p, a + step) -
                             pressurised_crack_volume(shape, modulus, p, a - step);
        const double k = pressurised_crack_intensity(shape, p, a);
        check_relative(0.5 * p * grown / area, k * k / modulus, 1e-8);
        const double critical = pressurised_crack_critical(shape, modulus, k * k / modulus, a);
        check_relative(critical, p, 1e-14);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(printed), cmocka_unit_test(consistent)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
