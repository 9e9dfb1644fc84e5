/* Terzaghi's and Mandel's series: printed digits, the equation of diffusion, and what holds at all times. */
#include "tests/physics/consolidation.h"
#include "base/par.h"
#include "tests/check.h"

enum { TIMES = 7 };
static const double TIME[TIMES] = {0.01, 0.05, 0.1, 0.2, 0.5, 1, 2};

static void terzaghi_printed(void **state) {
    (void)state;
    const double base[TIMES] = {1.000000, 0.996869, 0.949305, 0.772312, 0.370777, 0.107977, 0.009157};
    const double degree[TIMES] = {0.112838, 0.252313, 0.356823, 0.504088, 0.763950, 0.931260, 0.994170};
    for (int i = 0; i < TIMES; i++) {
        check_close(consolidation_terzaghi(1, TIME[i]), base[i], 5.1e-7);
        check_close(consolidation_degree(TIME[i]), degree[i], 5.1e-7);
    }
}

/* Both forms of the sum are the same where one takes over from the other; the degree is 1 less the mean pressure. */
static void terzaghi_whole(void **state) {
    (void)state;
    enum { PARTS = 2000 };
    const double times[] = {0.003, 0.05 * (1 - 1e-14), 0.05, 0.7};
    for (int i = 0; i < 4; i++) {
        double mean = 0;
        for (int k = 0; k < PARTS; k++) mean += consolidation_terzaghi((k + 0.5) / PARTS, times[i]) / PARTS;
        check_close(1 - mean, consolidation_degree(times[i]), 1e-6);
    }
    for (int z = 0; z <= 4; z++)
        check_close(consolidation_terzaghi(0.25 * z, times[1]), consolidation_terzaghi(0.25 * z, 0.05), 1e-12);
    check_close(consolidation_degree(times[1]), consolidation_degree(0.05), 1e-12);
    check_equal(consolidation_terzaghi(0, 0), 0);
    check_equal(consolidation_terzaghi(0.5, 0), 1);
    check_equal(consolidation_degree(0), 0);
}

/* dp/dT - d2p/dx2 by central differences; in Mandel's slab it is the same at all x, since the sum of the stresses
 * depends on time alone. */
static double diffusion(int mandel, double x, double T) {
    const double h = 1e-3, dt = 1e-5;
    double p[5];
    for (int k = 0; k < 5; k++) {
        const double at = x + (k == 1 ? h : k == 2 ? -h : 0), then = T + (k == 3 ? dt : k == 4 ? -dt : 0);
        p[k] = mandel ? consolidation_mandel(0.25, 0.4, at, then) : consolidation_terzaghi(at, then);
    }
    return (p[3] - p[4]) / (2 * dt) - (p[1] + p[2] - 2 * p[0]) / (h * h);
}

static void diffuse(void **state) {
    (void)state;
    const double times[] = {0.03, 0.3};
    for (int i = 0; i < 2; i++)
        for (int z = 1; z < 4; z++) {
            check_close(diffusion(0, 0.25 * z, times[i]), 0, 2e-4);
            check_close(diffusion(1, 0.25 * z, times[i]), diffusion(1, 0.5, times[i]), 2e-4);
        }
    check_above(fabs(diffusion(1, 0.5, 0.3)), 0.01); /* it is not 0: the stress moves to the middle */
}

static void mandel_printed(void **state) {
    (void)state;
    const double stiff[TIMES] = {1.03875, 1.08676, 1.07755, 0.94304, 0.56099, 0.23345, 0.04043};
    const double soft[TIMES] = {1.02357, 1.05075, 1.02526, 0.87148, 0.47575, 0.17159, 0.02232};
    const double e = 3e9;
    const struct physics_consolidation in[2] = {{e, 0.25, 1, INFINITY, 2e-9}, {e, 0.25, 0.8, 2 * e, 2e-9}};
    const double undrained[2] = {consolidation_undrained(&in[0]), consolidation_undrained(&in[1])};
    for (int i = 0; i < TIMES; i++) {
        check_close(consolidation_mandel(0.25, undrained[0], 0, TIME[i]), stiff[i], 5.1e-6);
        check_close(consolidation_mandel(0.25, undrained[1], 0, TIME[i]), soft[i], 5.1e-6);
    }
    double most[2] = {0, 0};
    for (int i = 0; i < 200; i++)
        for (int m = 0; m < 2; m++)
            most[m] = fmax(most[m], consolidation_mandel(0.25, undrained[m], 0, 0.03 + 5e-4 * i));
    check_close(most[0], 1.0922, 6e-5);
    check_close(most[1], 1.0515, 6e-5);
}

/* It drains at its sides, begins with the undrained pressure, and the first root is found however small it is. */
static void mandel_ends(void **state) {
    (void)state;
    check_close(consolidation_mandel(0.25, 0.5, 1, 0.1), 0, 1e-14);
    check_close(consolidation_mandel(0.25, 0.5, 0.2, 1e-6), 1, 3e-3);
    check_relative(consolidation_mandel(0.25, 0.5, -0.3, 0.1), consolidation_mandel(0.25, 0.5, 0.3, 0.1), 1e-14);
    /* nu_u -> nu: the slab is a column that drains at both sides, p/p0 = Terzaghi's */
    check_close(consolidation_mandel(0.25, 0.25 + 1e-9, 0.4, 0.2), consolidation_terzaghi(0.6, 0.2), 1e-8);
    /* eta -> 1, nu = 0 and nu_u -> 1: the first root goes to 0 as sqrt(3 (eta - 1)) */
    const double eta = 1.0001, T = 100, rate = 3 * (eta - 1);
    const double decay = log(consolidation_mandel(0, 1 / eta, 0, T) / consolidation_mandel(0, 1 / eta, 0, 2 * T)) / T;
    check_relative(decay, rate, 1e-3);
}

static void constants(void **state) {
    (void)state;
    const double e = 3e9, k = 2e-9;
    const struct physics_consolidation stiff = {e, 0.25, 1, INFINITY, k}, in = {e, 0.25, 0.8, 2 * e, k};
    check_relative(physics_consolidation_coefficient(&stiff), 1.2 * e * k, 1e-14);
    check_relative(physics_consolidation_coefficient(&in), k / (1 / (2 * e) + 0.64 / (1.2 * e)), 1e-14);
    check_relative(consolidation_undrained(&stiff), 0.5, 1e-14);
    check_relative(consolidation_skempton(&stiff), 1, 1e-14);
    const double bulk = e / 1.5, undrained = bulk + 0.64 * 2 * e, shear = e / 2.5;
    check_relative(consolidation_skempton(&in), 0.8 * 2 * e / undrained, 1e-14);
    check_relative(consolidation_undrained(&in), (3 * undrained - 2 * shear) / (2 * (3 * undrained + shear)), 1e-14);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(terzaghi_printed), cmocka_unit_test(terzaghi_whole),
                                       cmocka_unit_test(diffuse),          cmocka_unit_test(mandel_printed),
                                       cmocka_unit_test(mandel_ends),      cmocka_unit_test(constants)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
