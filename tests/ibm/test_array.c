/* Permeability of a cubic array of spheres against Zick and Homsy (1982). */
/* Permeability of a simple cubic array of spheres as frana makes bodies: markers at the outer layer of a lattice, with
 * the frozen retraction. k / L^2 = 0.0398542 at a solid fraction of 1/8 (Zick and Homsy 1982: K = 4.292). */
#include "tests/ibm/flows.h"
#include "physics/retraction.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

static double error_of(int n, const double sphere[3], const double lattice[3]) {
    struct array_case c = {
        .n = n, .solid_fraction = 0.125, .depth = BODY_COUNTED, .retraction = PHYSICS_RETRACTION, .forcing = {2, 1, 0}};
    for (int d = 0; d < 3; d++) c.sphere[d] = sphere[d], c.lattice[d] = lattice[d];
    struct flow_result result;
    const double error = array_error(&c, &result);
    print_message("%d^3: k %+.2f %%, slip %.2g of the mean velocity, %ld markers, %ld steps, %.1f s\n", n, 100 * error,
                  result.slip, result.markers, result.steps, result.seconds);
    check_below(result.slip, 0.05);
    return error;
}

/* The same body at other positions on the grid; on more than one rank only the first. */
static void wherever_the_body_stands(void **state) {
    (void)state;
    static const double place[3][3] = {{0, 0, 0}, {0.3, 0.1, 0.7}, {0.5, 0.5, 0.5}};
    double low = INFINITY, high = -INFINITY;
    for (int n = 0; n < (par_size() == 1 ? 3 : 1); n++) {
        const double e = error_of(32, place[n], place[n]);
        if (!(fabs(e) < 0.03)) fail_msg("k is %g %% off", 100 * e);
        low = fmin(low, e), high = fmax(high, e);
    }
    if (!(high - low < 0.02)) fail_msg("k varies by %g %% with the body's place on the grid", 100 * (high - low));
}

/* Other lattice sites inside the same sphere: another rough surface. */
static void however_the_lattice_cuts_it(void **state) {
    (void)state;
    static const double centre[3] = {0.25, 0.6, 0.4}, site[3] = {0, 0, 0};
    if (par_size() > 1) return;
    const double e = error_of(32, centre, site);
    if (!(fabs(e) < 0.03)) fail_msg("k is %g %% off", 100 * e);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(wherever_the_body_stands),
                                       cmocka_unit_test(however_the_lattice_cuts_it)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
