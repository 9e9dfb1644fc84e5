/* Drag of grains: Stokes's sphere, a packed bed by hand, a single sphere at a high Reynolds number. */
#include "physics/packed_drag.h"
#include "tests/check.h"

/* 3 pi mu d U over the volume of a sphere, for a few grains in much fluid. */
static void slow_single_grains(void **state) {
    (void)state;
    const double d = 1e-3, u = 1e-9, mu = 1e-3, solid = 1e-6;
    check_relative(physics_packed_drag(1 - solid, u, d, 1000, mu), solid * 18 * mu * u / (d * d), 1e-3);
}

/* Cd = 0.44 above Re = 1000. */
static void fast_single_grains(void **state) {
    (void)state;
    const double solid = 1e-6;
    check_relative(physics_packed_drag(1 - solid, 10, 0.01, 1000, 1e-3), solid * 0.75 * 0.44 * 1000 * 100 / 0.01, 1e-5);
}

/* Porosity 0.4, d = 1 mm, water at 1 mm/s: 150 0.36/0.064 + 1.75 0.6/0.064 = 843.75 + 16.40625 Pa/m. */
static void a_packed_bed(void **state) {
    (void)state;
    check_relative(physics_packed_drag(0.4, 1e-3, 1e-3, 1000, 1e-3), 843.75 + 16.40625, 1e-12);
    assert_true(physics_packed_drag(0.4, 0, 1e-3, 1000, 1e-3) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(slow_single_grains), cmocka_unit_test(fast_single_grains),
                                       cmocka_unit_test(a_packed_bed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
