/* Effective position of a plane wall of markers against its offset from the grid. */
/* Where the flow feels a plane wall of markers, against the offset from the grid.
 * A force spread over three cells bends the profile there: u_i - U = s sum_j phi_j |i - j| on both sides, and the
 * markers' own velocity is the mean of u with the same weights. So the far profile reaches the wall's velocity e =
 * sum_ij phi_i phi_j |i - j| = 1/2 + 2 phi(t-1) phi(t+1)   with fluid sheared alike on both sides of a sheet, e / 2
 * with fluid at rest behind it (a thick body), cells out from the markers; t: the marker from the nearest grid point.
 * Between 0.25 and 0.278 for a body: locked to the grid by no more than 0.03 cells. */
#include "flows.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

static double sheet(double offset) {
    const double t = offset - 0.5; /* u stands at the cells' centres */
    return 0.5 + 2 * ibm_kernel(t - 1) * ibm_kernel(t + 1);
}

static void thick_walls(void **state) {
    (void)state;
    double low = INFINITY, high = -INFINITY;
    for (int n = 0; n < 10; n++) {
        const double e = walls_shift(0.1 * n, 1, 2, 1);
        print_message("offset 0.%d: the wall stands %.4f cells out, %.4f without slip\n", n, e, sheet(0.1 * n) / 2);
        /* what slip is left after two iterations moves the wall back, by less than 0.01 cells */
        if (!(fabs(e - sheet(0.1 * n) / 2) < 0.01)) fail_msg("offset %g: e = %g", 0.1 * n, e);
        low = fmin(low, e), high = fmax(high, e);
    }
    if (!(high - low < 0.03)) fail_msg("spread %g cells", high - low);
}

static void thin_sheets(void **state) {
    (void)state;
    struct flow_result result;
    for (int n = 0; n <= 5; n += 5) {
        const double e = sheets_shift(16, 0.1 * n, 1, 2, 1, &result);
        if (!(fabs(e - sheet(0.1 * n)) < 0.01)) fail_msg("offset %g: e = %g, not %g", 0.1 * n, e, sheet(0.1 * n));
        check_below(result.slip, 0.02);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(thick_walls), cmocka_unit_test(thin_sheets)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
