/* Cracks of four horizons' half length and radius under uniform pressure at rest, against linear elasticity. */
#include "tests/cracks/at_rest.h"

/* Opening 3.75 p a/E, volume 5.8905 p a^2/E. */
static void plate(void **state) {
    (void)state;
    const struct found f = at_rest((int[3]){192, 192, 0}, 12);
    check_relative(f.opening, 1, 0.05);
    check_relative(f.volume, 1, 0.05);
    check_between(f.critical / 0.58269, 1.1, 1.4);
}

/* Opening 2.3873 p a/E, volume 5 p a^3/E. */
static void penny(void **state) {
    (void)state;
    const struct found f = at_rest((int[3]){60, 60, 60}, 12);
    check_relative(f.opening, 1, 0.08);
    check_relative(f.volume, 1, 0.08);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(plate), cmocka_unit_test(penny)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
