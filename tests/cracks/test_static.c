/* A straight crack under uniform pressure at rest, of two horizons' half length. */
#include "tests/cracks/at_rest.h"

/* Opening in the middle 3.75 p a/E, volume 5.8905 p a^2/E in an endless plate. This one is sixteen half lengths wide,
 * which adds about 1 %. The cut ends within the reach of a bond, which is 1/12 of the half length here. A bond at its
 * end breaks at 1.3 times Griffith's pressure, 0.58269 sqrt(E G0/a). */
static void plate(void **state) {
    (void)state;
    const struct found f = at_rest((int[3]){96, 96, 0}, 6);
    check_relative(f.opening, 1, 0.02);
    check_relative(f.volume, 1, 0.06);
    check_between(f.critical / 0.58269, 1.1, 1.4);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(plate)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
