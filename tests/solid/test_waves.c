/* Wave speeds in closed form. */
#include "base/par.h"
#include "solid/law/waves.h"
#include "tests/check.h"

/* In space and plane strain (nu = 1/4) c_l^2 = 6/5 E/rho and c_s^2 = 2/5 E/rho; in plane stress (nu = 1/3) 9/8 and
 * 3/8. So c_l^2 = 3 c_s^2 in all of them, where Rayleigh's cubic has the root (c/c_s)^2 = 2 - 2/sqrt(3). */
static void speeds_in_closed_form(void **state) {
    (void)state;
    const enum solid_model model[3] = {SOLID_3D, SOLID_PLANE_STRAIN, SOLID_PLANE_STRESS};
    const double longitudinal[3] = {1.2, 1.2, 1.125}, shear[3] = {0.4, 0.4, 0.375};
    const double e = 3.2e9, density = 1180;
    for (int k = 0; k < 3; k++) {
        const struct solid_waves w = solid_waves_of(model[k], e, density);
        check_relative(w.longitudinal, sqrt(longitudinal[k] * e / density), 1e-14);
        check_relative(w.shear, sqrt(shear[k] * e / density), 1e-14);
        check_relative(w.rayleigh, w.shear * sqrt(2 - 2 / sqrt(3)), 1e-12);
    }
}

/* Soda-lime glass as a plate: 3058 m/s, to the digits that are published. */
static void soda_lime_glass(void **state) {
    (void)state;
    check_close(solid_waves_of(SOLID_PLANE_STRESS, 72e9, 2440).rayleigh, 3058.4, 0.1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(speeds_in_closed_form), cmocka_unit_test(soda_lime_glass)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
