/* Reductions, broadcasts and gatherings against sums over the ranks' known values. */
#include "base/par.h"
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>

/* The values alternate in sign, and the extremes are on different ranks. */
static double value_of(int rank, int i) { return (rank % 2 ? -1 : 1) * (10. * rank + i + 1); }

static void reductions(void **state) {
    (void)state;
    enum { N = 5 };
    const int size = par_size(), rank = par_rank();
    double sum[N] = {0}, least[N], most[N], all[3][N];
    long whole[N], total[N] = {0}, before = 0;
    for (int i = 0; i < N; i++) {
        least[i] = INFINITY;
        most[i] = -INFINITY;
        for (int r = 0; r < size; r++) {
            sum[i] += value_of(r, i);
            least[i] = fmin(least[i], value_of(r, i));
            most[i] = fmax(most[i], value_of(r, i));
            total[i] += (1L << 40) * r + i;
        }
        for (int k = 0; k < 3; k++) all[k][i] = value_of(rank, i);
        whole[i] = (1L << 40) * rank + i; /* beyond the range of int */
    }
    par_sum_array(all[0], N);
    par_min_array(all[1], N);
    par_max_array(all[2], N);
    par_sum_long_array(whole, N);
    for (int i = 0; i < N; i++) {
        check_equal(all[0][i], sum[i]);
        check_equal(all[1][i], least[i]);
        check_equal(all[2][i], most[i]);
        assert_int_equal(whole[i], total[i]);
        check_equal(par_sum(value_of(rank, i)), sum[i]);
        check_equal(par_min(value_of(rank, i)), least[i]);
        check_equal(par_max(value_of(rank, i)), most[i]);
    }
    assert_int_equal(par_sum_long((1L << 40) * rank), total[0]);
    for (int r = 0; r < rank; r++) before += 3 * r + 1;
    assert_int_equal(par_sum_before(3 * rank + 1), before);
}

static void a_broadcast_is_from_its_root(void **state) {
    (void)state;
    for (int root = 0; root < par_size(); root++) {
        char text[20];
        snprintf(text, sizeof text, "from rank %d", par_rank());
        par_bcast(text, sizeof text, root);
        assert_int_equal(atoi(text + 10), root);
    }
}

static void equal_pieces_are_gathered(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank();
    const double mine[2] = {value_of(rank, 0), value_of(rank, 1)};
    double *everyone = calloc(2 * (size_t)size, sizeof *everyone);
    par_gather(mine, sizeof mine, everyone);
    for (int i = 0; i < 2 * size; i++) check_equal(everyone[i], rank == 0 ? value_of(i / 2, i % 2) : 0);
    par_all_gather(mine, sizeof mine, everyone);
    for (int i = 0; i < 2 * size; i++) check_equal(everyone[i], value_of(i / 2, i % 2));
    free(everyone);
}

/* Rank r gives 3 r bytes, rank 0 none. */
static void unequal_pieces_are_gathered(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank();
    char mine[100];
    size_t total = 99;
    memset(mine, 'a' + rank, sizeof mine);
    char *all = par_all_gather_any(mine, 3 * (size_t)rank, &total);
    assert_int_equal(total, 3 * size * (size - 1) / 2);
    for (int r = 0, k = 0; r < size; r++)
        for (int i = 0; i < 3 * r; i++) assert_int_equal(all[k++], 'a' + r);
    free(all);
}

static void the_clock_never_goes_back(void **state) {
    (void)state;
    double last = par_seconds();
    for (int i = 0; i < 1000; i++) {
        const double now = par_seconds();
        check_at_least(now, last);
        last = now;
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(reductions), cmocka_unit_test(a_broadcast_is_from_its_root),
                                       cmocka_unit_test(equal_pieces_are_gathered),
                                       cmocka_unit_test(unequal_pieces_are_gathered),
                                       cmocka_unit_test(the_clock_never_goes_back)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
