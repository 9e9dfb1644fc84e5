/* The division of cells over pieces: no gap, no overlap, as even as it can be, and the inverse. */
#include "base/par_piece.h"
#include "tests/check.h"

static void pieces_cover_the_cells_evenly(void **state) {
    (void)state;
    for (int n = 1; n <= 40; n++)
        for (int pieces = 1; pieces <= 50; pieces++) {
            assert_int_equal(par_piece_low(n, pieces, 0), 0);
            assert_int_equal(par_piece_low(n, pieces, pieces), n);
            for (int c = 0; c < pieces; c++) {
                const int m = par_piece_low(n, pieces, c + 1) - par_piece_low(n, pieces, c);
                assert_true(m == n / pieces || m == (n + pieces - 1) / pieces);
            }
        }
}

static void each_cell_is_in_the_piece_that_is_said(void **state) {
    (void)state;
    for (int n = 1; n <= 40; n++)
        for (int pieces = 1; pieces <= 50; pieces++) {
            int first[51];
            par_piece_cut(n, NULL, pieces, 0, first);
            for (int i = 0; i < n; i++) {
                const int c = par_piece_of(first, pieces, i);
                assert_int_equal(first[c], par_piece_low(n, pieces, c));
                assert_true(first[c] <= i && i < first[c + 1]);
            }
        }
}

/* The least of the largest sum, by trying all ways to cut. */
static double best(int n, const double *weight, int pieces, int least) {
    double sum = 0, most = INFINITY;
    if (pieces == 1) {
        for (int i = 0; i < n; i++) sum += weight[i];
        return sum;
    }
    for (int i = 0; i <= n - least * (pieces - 1); i++) {
        if (i >= least) most = fmin(most, fmax(sum, best(n - i, weight + i, pieces - 1, least)));
        if (i < n) sum += weight[i];
    }
    return most;
}

static void weights_are_cut_as_well_as_possible(void **state) {
    (void)state;
    for (int kind = 0; kind < 60; kind++) {
        const int n = 9 + kind % 5, pieces = 1 + kind % 4, least = kind % 3;
        double weight[16];
        int first[8];
        for (int i = 0; i < n; i++) weight[i] = kind % 7 == 0 ? 1 : (i * 7 + kind) % 5 + (i == kind % n ? 20 : 0);
        par_piece_cut(n, weight, pieces, least, first);
        double most = 0;
        assert_int_equal(first[0], 0);
        assert_int_equal(first[pieces], n);
        for (int c = 0; c < pieces; c++) {
            double sum = 0;
            check_at_least(first[c + 1] - first[c], least);
            for (int i = first[c]; i < first[c + 1]; i++) sum += weight[i];
            most = fmax(most, sum);
        }
        check_relative(most, best(n, weight, pieces, least), 1e-12);
    }
}

/* The product of cells and pieces is beyond the range of int. */
static void large_numbers_do_not_overflow(void **state) {
    (void)state;
    const int n = 1000000, pieces = 30000;
    assert_int_equal(par_piece_low(n, pieces, pieces), n);
    assert_int_equal(par_piece_low(n, pieces, pieces / 2), n / 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_cover_the_cells_evenly), cmocka_unit_test(each_cell_is_in_the_piece_that_is_said),
        cmocka_unit_test(weights_are_cut_as_well_as_possible), cmocka_unit_test(large_numbers_do_not_overflow)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
