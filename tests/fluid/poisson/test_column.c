/* Column solver on any number of ranks against LAPACK, for every pair of ends and near-singular systems. */
/* Columns divided over ranks, also where r^k vanishes, where the system is nearly singular, and where it is
 * singular. */
#include "base/par_count.h"
#include "base/par_piece.h"
#include "fluid/poisson/column.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <lapacke.h>
#include <stdlib.h>

enum { COLUMNS = 13, ENDS = 6 };
static const enum fluid_end ends[ENDS][2] = {
    {FLUID_END_PERIODIC, FLUID_END_PERIODIC}, {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET},
    {FLUID_END_NEUMANN, FLUID_END_NEUMANN},   {FLUID_END_DIRICHLET, FLUID_END_NEUMANN},
    {FLUID_END_NEUMANN, FLUID_END_DIRICHLET}, {FLUID_END_FACE, FLUID_END_FACE}};

static const double lambda[COLUMNS] = {0, -1e-6, -1e-4, -1e-2, -0.1, -1, -3, -10, -100, -1e3, -1e4, -1e6, -1e-3};

/* One column whole, as a dense system. */
static void reference(int n, double d, int pair, double l, const double *b, double *q) {
    const double a = 1 / (d * d);
    const int last = n - 1, periodic = ends[pair][0] == FLUID_END_PERIODIC;
    const int faces = ends[pair][0] == FLUID_END_FACE;
    double *matrix = calloc((size_t)n * (size_t)n, sizeof *matrix);
    lapack_int *pivot = malloc((size_t)n * sizeof *pivot);
    for (int k = 0; k < n; k++) {
        matrix[k * n + k] += l - 2 * a;
        if (k > 0) matrix[k * n + k - 1] += a;
        if (k < last) matrix[k * n + k + 1] += a;
        q[k] = b[k];
    }
    if (periodic) {
        matrix[last] += a;
        matrix[last * n] += a;
    } else if (faces) { /* q[-1] = 0 as it stands, q[n-1] = 0 for its own equation */
        for (int k = 0; k < n; k++) matrix[last * n + k] = k == last;
        q[last] = 0;
    } else {
        matrix[0] += ends[pair][0] == FLUID_END_NEUMANN ? a : -a;
        matrix[last * n + last] += ends[pair][1] == FLUID_END_NEUMANN ? a : -a;
    }
    assert_int_equal(LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, matrix, n, pivot, q, 1), 0);
    free(matrix);
    free(pivot);
}

static double right_hand_side(int column, int k) { return random_at(column, k, 3, 4); }

/* What a rank sends, there and back: to all others, or in groups of equal size to those of its group and to one of each
 * group. All ranks together send as many values in groups as without. */
static void assert_sent(int groups, struct par_count was) {
    const int size = par_size(), several = groups > 0 ? groups : size > 8 ? (int)lround(sqrt(size)) : 1;
    const struct par_count now = par_count_of(PAR_COUNT_TRANSPOSE);
    assert_int_equal(par_sum_long(now.bytes - was.bytes), 8L * 4 * COLUMNS * (size - 1));
    if (size % several) return;
    assert_int_equal(now.messages - was.messages, 2 * (size / several - 1) + 2 * (several - 1));
}

/* Largest difference over the largest value, of all columns but the singular one; that one's residual and mean.
 * expected: [COLUMNS][n] */
static void compare(int groups, int n, double d, int pair, const double *expected) {
    const int size = par_size(), low = par_piece_low(n, size, par_rank()),
              m = par_piece_low(n, size, par_rank() + 1) - low;
    const int singular = ends[pair][0] == FLUID_END_PERIODIC ||
                         (ends[pair][0] == FLUID_END_NEUMANN && ends[pair][1] == FLUID_END_NEUMANN);
    const double scale = 0.7, mean = 0.25;
    const struct fluid_column_input in = {.n = n,
                                          .ranks = {1, 1, size},
                                          .groups = groups,
                                          .d = d,
                                          .scale = scale,
                                          .low = ends[pair][0],
                                          .high = ends[pair][1],
                                          .columns = COLUMNS,
                                          .lambda = lambda,
                                          .free_mean = singular};
    struct fluid_column *c = fluid_column_new(&in);
    double *y = calloc((size_t)(m + 1) * COLUMNS, sizeof *y), *q = calloc((size_t)n * COLUMNS, sizeof *q);
    double *b = malloc((size_t)n * sizeof *b);
    for (int k = 0; k < m; k++) {
        for (int i = 0; i < COLUMNS; i++) y[k * COLUMNS + i] = right_hand_side(i, low + k) / scale;
        fluid_column_up(c, k, 0, COLUMNS, k > 0 ? y + (k - 1) * COLUMNS : NULL, y + k * COLUMNS, NULL);
    }
    const struct par_count was = par_count_of(PAR_COUNT_TRANSPOSE);
    fluid_column_couple(c, y, COLUMNS, mean);
    assert_sent(groups, was);
    for (int k = m; k >= 0; k--) {
        fluid_column_down(c, k, 0, COLUMNS, y + k * COLUMNS);
        const double *plane = fluid_column_found(c, k);
        for (int i = 0; i < COLUMNS && k < m; i++) q[i * n + low + k] = plane[i];
    }
    par_sum_array(q, n * COLUMNS);
    for (int i = 0; i < COLUMNS; i++) {
        double worst = 0, most = 0, sum = 0, average = 0;
        for (int k = 0; k < n; k++) sum += b[k] = right_hand_side(i, k);
        if (singular && lambda[i] == 0) {
            for (int k = 0; k < n; k++) {
                const int wraps = ends[pair][0] == FLUID_END_PERIODIC;
                const double *x = q + i * n;
                const double before = k > 0 ? x[k - 1] : x[wraps ? n - 1 : 0];
                const double after = k < n - 1 ? x[k + 1] : x[wraps ? 0 : n - 1];
                worst = check_worst(worst, before - 2 * x[k] + after - d * d * (b[k] - sum / n));
                most = fmax(most, fabs(x[k]));
                average += x[k] / n;
            }
            check_close(average, mean, 1e-13 * most);
            if (!(worst < 1e-14 * most)) fail_msg("ends %d, singular: residual %g of %g", pair, worst, most);
            continue;
        }
        for (int k = 0; k < n; k++) {
            worst = check_worst(worst, q[i * n + k] - expected[i * n + k]);
            most = fmax(most, fabs(expected[i * n + k]));
        }
        /* round-off times the condition of the system, at most that of the whole operator over its smallest eigenvalue
         */
        const double smallest = fmax(-lambda[i], singular ? 0 : 1 / (n * d * n * d));
        const double tolerance = 1e-14 + 1e-15 * (4 / (d * d) - lambda[i]) / smallest;
        if (!(worst < tolerance * most))
            fail_msg("%d groups, ends %d, lambda %g: %g of %g", groups, pair, lambda[i], worst, most);
    }
    free(y);
    free(q);
    free(b);
    fluid_column_free(c);
}

/* In one level, and in two with groups of equal or unequal numbers of ranks, or of one rank each. */
static void against_lapack(int n, double d, int pair) {
    const int singular = ends[pair][0] == FLUID_END_PERIODIC ||
                         (ends[pair][0] == FLUID_END_NEUMANN && ends[pair][1] == FLUID_END_NEUMANN);
    double *b = malloc((size_t)n * sizeof *b), *expected = malloc((size_t)(n * COLUMNS) * sizeof *expected);
    for (int i = 0; i < COLUMNS; i++) {
        for (int k = 0; k < n; k++) b[k] = right_hand_side(i, k);
        if (!singular || lambda[i] != 0) reference(n, d, pair, lambda[i], b, expected + i * n);
    }
    const int groups[] = {0, 2, par_size()};
    for (int g = 0; g < 3; g++)
        if (g == 0 || groups[g] > groups[g - 1]) compare(groups[g], n, d, pair, expected);
    free(b);
    free(expected);
}

static void short_columns(void **state) {
    (void)state;
    for (int pair = 0; pair < ENDS; pair++) against_lapack(9, 0.3, pair);
}

static void long_columns(void **state) {
    (void)state;
    for (int pair = 0; pair < ENDS; pair++) against_lapack(300, 0.01, pair);
}

/* A cell much longer than the waves across it, and a cell much shorter. */
static void flat_and_steep(void **state) {
    (void)state;
    for (int pair = 0; pair < ENDS; pair++) {
        against_lapack(12, 30, pair);
        against_lapack(64, 1e-3, pair);
    }
}

/* As few planes as there are ranks. */
static void one_plane_each(void **state) {
    (void)state;
    for (int pair = 0; pair < ENDS; pair++) against_lapack(par_size() > 1 ? par_size() : 2, 0.4, pair);
}

FLUID_TEST_MAIN(cmocka_unit_test(short_columns), cmocka_unit_test(long_columns), cmocka_unit_test(flat_and_steep),
                cmocka_unit_test(one_plane_each))
