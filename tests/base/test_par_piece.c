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
        for (int pieces = 1; pieces <= 50; pieces++)
            for (int i = 0; i < n; i++) {
                const int c = par_piece_of(n, pieces, i);
                assert_true(par_piece_low(n, pieces, c) <= i && i < par_piece_low(n, pieces, c + 1));
            }
}

/* The product of cells and pieces is beyond the range of int. */
static void large_numbers_do_not_overflow(void **state) {
    (void)state;
    const int n = 1000000, pieces = 30000;
    assert_int_equal(par_piece_low(n, pieces, pieces), n);
    assert_int_equal(par_piece_low(n, pieces, pieces / 2), n / 2);
    assert_int_equal(par_piece_of(n, pieces, n - 1), pieces - 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pieces_cover_the_cells_evenly),
                                       cmocka_unit_test(each_cell_is_in_the_piece_that_is_said),
                                       cmocka_unit_test(large_numbers_do_not_overflow)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
