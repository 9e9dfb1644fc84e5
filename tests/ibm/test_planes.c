/* Effective position of a plane wall of markers against its offset from the grid. */
/* A force spread over three cells bends the profile there: u_i - U = s sum_j phi_j |i - j| on both sides, and the
 * markers' own velocity is the mean of u with the same weights. So the far profile reaches the wall's velocity at a
 * distance, in cells, from the markers of
 *     e = sum_ij phi_i phi_j |i - j| = 1/2 + 2 phi(t-1) phi(t+1)   for equal shear on both sides of a sheet,
 *     e / 2                                                        for fluid at rest behind it (a thick body),
 * with t the position of the marker relative to the nearest grid point. For a body the distance is between 0.25 and
 * 0.278: it depends on the grid by at most 0.03 cells. */
#include "tests/ibm/flows.h"
#include "physics/retraction.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

static const struct flow_forcing multidirect = {2, 1, 0};

static double sheet(double offset) {
    const double t = offset - 0.5; /* u is at the cells' centres */
    return 0.5 + 2 * ibm_kernel(t - 1) * ibm_kernel(t + 1);
}

static void thick_walls(void **state) {
    (void)state;
    double low = INFINITY, high = -INFINITY;
    for (int n = 0; n < 10; n++) {
        const double e = walls_shift(0.1 * n, 1, &multidirect);
        print_message("offset 0.%d: the wall stands %.4f cells out, %.4f without slip\n", n, e, sheet(0.1 * n) / 2);
        /* the slip left after two iterations moves the wall back, by less than 0.01 cells */
        if (!(fabs(e - sheet(0.1 * n) / 2) < 0.01)) fail_msg("offset %g: e = %g", 0.1 * n, e);
        low = fmin(low, e), high = fmax(high, e);
    }
    if (!(high - low < 0.03)) fail_msg("spread %g cells", high - low);
}

/* With feedback the slip is too small to be seen. */
static void thick_walls_with_feedback(void **state) {
    (void)state;
    const struct flow_forcing feedback = {2, 1, 0.03};
    for (int n = 0; n < 10; n += 3) {
        const double e = walls_shift(0.1 * n, 1, &feedback);
        if (!(fabs(e - sheet(0.1 * n) / 2) < 0.003)) fail_msg("offset %g: e = %g", 0.1 * n, e);
    }
}

/* Inclined faces that are cut from the lattice, with the depth by their neighbours' number and the frozen retraction;
 * and those along it. */
static void inclined_walls(void **state) {
    (void)state;
    static const struct {
        int across[3], period;
        double way[3];
    } slab[5] = {{{1, 0, 0}, 40, {0, 0, 1}},
                 {{1, 1, 0}, 56, {0, 0, 1}},
                 {{1, 1, 0}, 56, {M_SQRT1_2, -M_SQRT1_2, 0}},
                 {{1, 2, 0}, 88, {0, 0, 1}},
                 {{1, 2, 0}, 88, {0.894427190999916, -0.447213595499958, 0}}};
    const struct flow_forcing feedback = {2, 1, 0.03};
    for (int n = 0; n < 5; n++) {
        if (check_skips(n, 2)) continue;
        const double shift = slabs_shift(slab[n].across, slab[n].period, slab[n].way, n ? 0.05 : 0, BODY_COUNTED,
                                         PHYSICS_RETRACTION, &feedback);
        print_message("normal %d %d %d: a gap %+.3f cells too wide on each side\n", slab[n].across[0],
                      slab[n].across[1], slab[n].across[2], shift);
        if (!(fabs(shift) < 0.025)) fail_msg("normal %d %d: %g", slab[n].across[0], slab[n].across[1], shift);
    }
}

static void thin_sheets(void **state) {
    (void)state;
    struct flow_result result;
    for (int n = 0; n <= 5; n += 5) {
        const double e = sheets_shift(16, 0.1 * n, 1, &multidirect, &result);
        if (!(fabs(e - sheet(0.1 * n)) < 0.01)) fail_msg("offset %g: e = %g, not %g", 0.1 * n, e, sheet(0.1 * n));
        check_below(result.slip, 0.02);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(thick_walls), cmocka_unit_test(thick_walls_with_feedback),
                                       cmocka_unit_test(inclined_walls), cmocka_unit_test(thin_sheets)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
