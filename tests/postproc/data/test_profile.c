/* Means over cross sections, by hand. */
#include "base/par.h"
#include "postproc/data/profile.h"
#include "tests/check.h"

static void profile_by_sections(void **state) {
    (void)state;
    /* two sections of four cells: pressure 1, 2, 3, 4 and solid 0, 0, 1, 0.5 */
    const int n[3] = {2, 2, 2};
    const double pressure[8] = {1, 7, 2, 7, 3, 7, 4, 7}, solid[8] = {0, 1, 0, 1, 1, 1, 0.5, 1};
    double mean[2], fluid[2], porosity[2];
    postproc_profile_means(n, pressure, solid, mean, fluid, porosity);
    check_close(mean[0], 2.5, 1e-14);
    check_close(fluid[0], (1 + 2 + 0.5 * 4) / 2.5, 1e-14);
    check_close(porosity[0], 2.5 / 4, 1e-14);
    check_close(mean[1], 7, 1e-14);
    assert_true(isnan(fluid[1]));
    check_close(porosity[1], 0, 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(profile_by_sections)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
