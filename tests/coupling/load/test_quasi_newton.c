/* Fixed points of maps for which plain iteration diverges, on unevenly divided vectors. */
#include "base/par.h"
#include "coupling/load/quasi_newton.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>

enum { N = 60, MODES = 3 };

/* H(x) = root + sum of gain_j e_j e_j.(x - root), e_j orthonormal cosines over all ranks' unknowns. */
struct map {
    int n, first;       /* this rank's unknowns, of N */
    double root[N];     /* [n] */
    double gain[MODES]; /* 1 + gain of the interface: below -1 an iteration diverges */
};

static struct map map_of(double amplitude) {
    struct map m = {.gain = {-9, -2.5, 0.6}};
    const int size = par_size(), rank = par_rank();
    m.first = rank == 0 ? 0 : N * (rank + 1) / (size + 1); /* rank 0 has twice the others' share */
    m.n = N * (rank + 2) / (size + 1) - m.first;
    for (int i = 0; i < m.n; i++) m.root[i] = amplitude * sin(0.37 * (m.first + i) * (m.first + i));
    return m;
}

static double mode(int j, int i) { return sqrt(2. / N) * cos(M_PI * (2 * j + 1) * (i + 0.5) / N); }

static void apply(const struct map *m, const double *x, double *image) {
    double part[MODES] = {0};
    for (int j = 0; j < MODES; j++)
        for (int i = 0; i < m->n; i++) part[j] += mode(j, m->first + i) * (x[i] - m->root[i]);
    par_sum_array(part, MODES);
    for (int i = 0; i < m->n; i++) {
        image[i] = m->root[i];
        for (int j = 0; j < MODES; j++) image[i] += m->gain[j] * part[j] * mode(j, m->first + i);
    }
}

/* Iterations until |H(x) - x| < 1e-10, from 0; `most` if that is not reached. */
static int solve(struct quasi_newton *q, const struct map *m, int most, double *x) {
    double image[N];
    for (int i = 0; i < m->n; i++) x[i] = 0;
    for (int k = 1; k < most; k++) {
        double square = 0;
        apply(m, x, image);
        for (int i = 0; i < m->n; i++) square += pow(image[i] - x[i], 2);
        if (sqrt(par_sum(square)) < 1e-10) return k;
        quasi_newton_next(q, x, image);
    }
    return most;
}

static struct quasi_newton *least_squares(void) {
    return quasi_newton_new(
        &(struct quasi_newton_input){QUASI_NEWTON_LEAST_SQUARES, .relaxation = 0.1, .filter = 1e-2});
}

static double error_of(const struct map *m, const double *x) {
    double error = 0;
    for (int i = 0; i < m->n; i++) error = check_worst(error, x[i] - m->root[i]);
    return par_max(error);
}

/* A map that is linear in three modes has residuals in four directions (the rest vanishes at once): with four columns
 * the next guess is the root, to round-off. */
static void test_finite_end(void **state) {
    (void)state;
    struct quasi_newton *q = least_squares();
    const struct map m = map_of(1);
    double x[N];
    quasi_newton_begin(q, m.n, 0);
    const int iterations = solve(q, &m, 50, x);
    check_at_most(iterations, MODES + 4);
    check_at_least(iterations, 4); /* there are three modes to be found */
    check_below(error_of(&m, x), 1e-9);
    quasi_newton_free(q);
}

/* Columns of one solve are used in the next, unless a rank asks to forget them or the unknowns have changed. */
static void test_learns(void **state) {
    (void)state;
    struct quasi_newton *q = least_squares();
    const struct map one = map_of(1), other = map_of(-0.7);
    double x[N];
    quasi_newton_begin(q, one.n, 0);
    const int first = solve(q, &one, 50, x);
    quasi_newton_begin(q, other.n, 0);
    check_above(quasi_newton_columns(q), 0);
    const int second = solve(q, &other, 50, x);
    check_at_most(second, 3);
    check_below(second, first);
    check_below(error_of(&other, x), 1e-9);
    quasi_newton_begin(q, other.n, par_rank() == par_size() - 1);
    assert_int_equal(quasi_newton_columns(q), 0);
    assert_int_equal(solve(q, &one, 50, x), first);
    quasi_newton_begin(q, other.n - (par_rank() == 0), 0);
    assert_int_equal(quasi_newton_columns(q), 0);
    quasi_newton_free(q);
}

/* Hundreds of solves fill no more columns than there are directions: dependent columns are dropped. */
static void test_filters(void **state) {
    (void)state;
    struct quasi_newton *q = least_squares();
    double x[N];
    int most = 0;
    for (int k = 0; k < 200; k++) {
        struct map m = map_of(cos(k));
        for (int j = 0; j < MODES; j++) m.gain[j] *= 1 + 0.02 * sin(k + j);
        quasi_newton_begin(q, m.n, 0);
        const int iterations = solve(q, &m, 50, x);
        if (k > 0) most = iterations > most ? iterations : most;
        check_below(error_of(&m, x), 1e-9);
    }
    check_at_most(quasi_newton_columns(q), MODES + 1);
    check_below(most, 12);
    quasi_newton_free(q);
}

/* By hand, H(x) = -3x + 8 in each unknown: r0 = 8, x1 = 0.8, r1 = 4.8, w = -0.1 * 8 (4.8 - 8)/(4.8 - 8)^2 = 0.25,
 * x2 = 0.8 + 0.25 * 4.8 = 2, the root. */
static void test_aitken(void **state) {
    (void)state;
    struct quasi_newton *q =
        quasi_newton_new(&(struct quasi_newton_input){QUASI_NEWTON_AITKEN, .relaxation = 0.1, .filter = 0});
    double x[2] = {0, 0}, image[2];
    const double expected[] = {0.8, 2};
    quasi_newton_begin(q, 2, 0);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 2; i++) image[i] = -3 * x[i] + 8;
        quasi_newton_next(q, x, image);
        for (int i = 0; i < 2; i++) check_close(x[i], expected[k], 1e-14);
    }
    quasi_newton_free(q);
    q = quasi_newton_new(&(struct quasi_newton_input){QUASI_NEWTON_AITKEN, .relaxation = 0.1, .filter = 0});
    const struct map m = map_of(1);
    double y[N];
    quasi_newton_begin(q, m.n, 0);
    check_below(solve(q, &m, 200, y), 200); /* one factor for three modes: slower, but it converges */
    check_below(error_of(&m, y), 1e-9);
    quasi_newton_free(q);
}

/* A zero residual leaves the guess unchanged. */
static void test_at_rest(void **state) {
    (void)state;
    struct quasi_newton *q = least_squares();
    double x[4] = {1, 2, 3, 4}, image[4] = {1, 2, 3, 4};
    quasi_newton_begin(q, 4, 0);
    for (int k = 0; k < 4; k++) quasi_newton_next(q, x, image);
    for (int i = 0; i < 4; i++) check_equal(x[i], i + 1);
    assert_int_equal(quasi_newton_columns(q), 0);
    quasi_newton_free(q);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_finite_end), cmocka_unit_test(test_learns),
                                       cmocka_unit_test(test_filters), cmocka_unit_test(test_aitken),
                                       cmocka_unit_test(test_at_rest)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
