/* Permeability of a cubic array of spheres against Zick and Homsy (1982). */
/* Permeability of a simple cubic array of spheres as frana makes bodies: markers at the outer layer of a lattice, at
 * the depth that their neighbours' number gives, with the frozen retraction. */
#include "tests/ibm/flows.h"
#include "physics/retraction.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

static const struct flow_forcing multidirect = {2, 1, 0}, feedback = {2, 1, 0.03};
static const double nowhere[3] = {0, 0, 0};

static double error_of(int n, double solid_fraction, const struct flow_forcing *forcing, const double sphere[3],
                       const double lattice[3]) {
    struct array_case c = {.n = n,
                           .solid_fraction = solid_fraction,
                           .depth = BODY_COUNTED,
                           .retraction = PHYSICS_RETRACTION,
                           .forcing = *forcing};
    for (int d = 0; d < 3; d++) c.sphere[d] = sphere[d], c.lattice[d] = lattice[d];
    struct flow_result result;
    const double error = array_error(&c, &result);
    print_message("%d^3, c = %g: k %+.2f %%, slip %.2g of the mean velocity, %ld markers, %ld steps, %.1f s\n", n,
                  solid_fraction, 100 * error, result.slip, result.markers, result.steps, result.seconds);
    check_below(result.slip, 0.02);
    return error;
}

/* The same body at other positions on the grid; on more than one rank only the first. */
static void wherever_the_body_stands(void **state) {
    (void)state;
    static const double place[3][3] = {{0, 0, 0}, {0.3, 0.1, 0.7}, {0.5, 0.5, 0.5}};
    double low = INFINITY, high = -INFINITY;
    for (int n = 0; n < (par_size() == 1 ? 3 : 1); n++) {
        if (check_skips(n, 2)) continue;
        const double e = error_of(32, 0.125, &multidirect, place[n], place[n]);
        if (!(fabs(e) < 0.02)) fail_msg("k is %g %% off", 100 * e);
        low = fmin(low, e), high = fmax(high, e);
    }
    if (!(high - low < 0.01)) fail_msg("k varies by %g %% with the body's place on the grid", 100 * (high - low));
}

static const double centre[4][3] = {{0.25, 0.6, 0.4}, {0.35, 0.85, 0.15}, {0.1, 0.45, 0.8}, {0.7, 0.2, 0.05}};

/* Other lattice sites inside the same sphere: another rough surface; the forcings take turns. */
static void however_the_lattice_cuts_it(void **state) {
    (void)state;
    if (par_size() > 1) return;
    for (int n = 0; n < 4; n++) {
        const int feeds_back = n & 1;
        if (check_skips(n + 1, 4)) continue;
        const double e =
            error_of(32, feeds_back ? 0.2 : 0.125, feeds_back ? &feedback : &multidirect, centre[n], nowhere);
        if (!(fabs(e) < (feeds_back ? 0.015 : 0.01)))
            fail_msg("k is %g %% off%s", 100 * e, feeds_back ? " with feedback" : "");
    }
}

/* Around a site or a corner of sites whole shells of sites enter the sphere together: at c = 0.2 and 32^3 the sites
 * fill 1.0 and 2.3 % more than the sphere, which alone takes 1.5 and 3.4 % of k. */
static void where_shells_enter_together(void **state) {
    (void)state;
    static const double site[2][3] = {{0, 0, 0}, {0.5, 0.5, 0.5}}, larger[2] = {-0.015, -0.034};
    if (par_size() > 1) return;
    for (int n = 0; n < 2; n++) {
        if (check_skips(n + 1, 3)) continue; /* by day however_the_lattice_cuts_it */
        const double e = error_of(32, 0.2, &feedback, nowhere, site[n]);
        if (!(fabs(e - larger[n]) < 0.01)) fail_msg("k is %g %% off, not %g %%", 100 * e, 100 * larger[n]);
    }
}

/* The forcing with feedback: k hardly depends on the step. It changes by 0.27 % because the slips of a step's stages
 * differ where the step is not much longer than the slip time. */
static void however_long_the_step(void **state) {
    (void)state;
    if (par_size() > 1 || check_skips(1, 2)) return; /* by day test_feedback.c has the step */
    const struct flow_forcing shorter = {2, 1 / 16.0, 0.03};
    const double e = error_of(16, 0.2, &feedback, centre[0], nowhere),
                 f = error_of(16, 0.2, &shorter, centre[0], nowhere);
    if (!(fabs(e - f) < 0.004)) fail_msg("k changes by %g %% with a sixteenth of the step", 100 * (f - e));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wherever_the_body_stands), cmocka_unit_test(however_the_lattice_cuts_it),
        cmocka_unit_test(where_shells_enter_together), cmocka_unit_test(however_long_the_step)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
