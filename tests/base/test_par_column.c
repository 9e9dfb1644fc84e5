/* Values of columns reach the columns' owners, and the results return. */
#include "base/par.h"
#include "base/par_column.h"
#include "tests/check.h"

enum { COLUMNS = 5, VALUES = 3, PARTS_MAX = 8 };

/* Value v of a column on the rank at c_y, place. */
static double value_of(int c_y, int place, int v, int column) { return 1000 * c_y + 100 * place + 10 * v + column; }

static void share_and_return(int owners) {
    const int wide = par_size() == 4 && owners < 3 ? 2 : 1, parts = par_size() / wide;
    const int c_y = par_rank() % wide, place = par_rank() / wide;
    int rank[PARTS_MAX];
    for (int q = 0; q < parts; q++) rank[q] = q * wide + c_y;
    const struct par_column_input in = {
        .parts = parts, .place = place, .rank = rank, .owners = owners, .columns = COLUMNS, .values = VALUES};
    struct par_column *c = par_column_new(&in);
    double array[VALUES][COLUMNS], of_all[PARTS_MAX * VALUES * COLUMNS];
    double *const mine[VALUES] = {array[0], array[1], array[2]};
    const double *const given[VALUES] = {array[0], array[1], array[2]};
    int low, count;
    par_column_own(c, &low, &count);
    assert_int_equal(place < owners || count == 0, 1);
    assert_int_equal(par_sum_long(count), COLUMNS * wide); /* each column has one owner along z */
    for (int v = 0; v < VALUES; v++)
        for (int i = 0; i < COLUMNS; i++) array[v][i] = value_of(c_y, place, v, i);
    par_column_share(c, given, of_all);
    for (int q = 0; q < parts; q++)
        for (int v = 0; v < VALUES; v++)
            for (int i = 0; i < count; i++) {
                double *at = &of_all[(q * VALUES + v) * count + i];
                check_equal(*at, value_of(c_y, q, v, low + i));
                *at *= -2;
            }
    par_column_return(c, of_all, mine);
    for (int v = 0; v < VALUES; v++)
        for (int i = 0; i < COLUMNS; i++) check_equal(array[v][i], -2 * value_of(c_y, place, v, i));
    par_column_free(c);
}

static void values_are_shared_and_return(void **state) {
    (void)state;
    share_and_return(par_size() == 4 ? 2 : par_size());
}

/* Some ranks own no columns. */
static void few_ranks_own_columns(void **state) {
    (void)state;
    share_and_return(1);
    if (par_size() > 3) share_and_return(3);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_are_shared_and_return),
                                       cmocka_unit_test(few_ranks_own_columns)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
