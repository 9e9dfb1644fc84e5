/* Griffith's criterion: tension, compression, where its two branches meet. */
#include "physics/griffith.h"

#include <stddef.h>
#include "tests/check.h"

static double tension(double a, double b, double c) { return physics_griffith_tension((double[]){a, b, c}); }

static void known_states(void **state) {
    (void)state;
    check_equal(tension(0, 0, 0), 0);
    check_equal(tension(5, 0, 0), 5);
    check_equal(tension(5, 5, 5), 5);
    check_equal(tension(2, 0, -2), 2);         /* shear */
    check_close(tension(0, 0, -8), 1, 1e-15);  /* eight times as strong under pressure */
    check_close(tension(0, -3, -8), 1, 1e-15); /* whatever the middle one is */
    check_equal(tension(-4, -4, -4), 0);       /* pressure from all sides breaks nothing */
    check_close(tension(-1, -1, -15), 196. / 128, 1e-15);
    for (int k = 0; k < 2; k++) check_close(tension(1, 0, -3 - k * 1e-9), 1, 1e-8); /* where the branches meet */
    check_close(tension(3e6, 0, -12e6), 3e6 * tension(1, 0, -4), 1e-9);             /* in any unit */
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(known_states)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
