/* Items arrive at the ranks that serve them, by rank and in order, and come back to their places. */
#include "base/par.h"
#include "base/par_exchange.h"
#include "tests/check.h"

enum { N = 23, MORE = 4 * N };

struct item {
    int rank, i;
};

/* The rank that serves item i of a rank; -1 for some of them. */
static int dest_of(int rank, int i) { return (i * i + 3 * rank) % (par_size() + 1) - 1; }

static void items_go_and_come_back(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank();
    struct item mine[N], served[MORE];
    int dest[N], expected = 0;
    for (int i = 0; i < N; i++) {
        mine[i] = (struct item){rank, i};
        dest[i] = dest_of(rank, i);
    }
    struct par_exchange *x = par_exchange_new(N, dest);
    par_exchange_forward(x, mine, served, sizeof *mine);
    for (int r = 0; r < size; r++)
        for (int i = 0; i < N; i++) {
            if (dest_of(r, i) != rank) continue;
            assert_int_equal(served[expected].rank, r);
            assert_int_equal(served[expected++].i, i);
        }
    assert_int_equal(par_exchange_count(x), expected);

    double back[N], value[MORE];
    for (int i = 0; i < N; i++) back[i] = -1;
    for (int k = 0; k < expected; k++) value[k] = 1000 * rank + 100 * served[k].rank + served[k].i;
    par_exchange_backward(x, value, back, sizeof *back);
    for (int i = 0; i < N; i++) check_equal(back[i], dest[i] < 0 ? -1 : 1000 * dest[i] + 100 * rank + i);
    par_exchange_free(x);
}

/* Item 0 goes to every rank, item 1 to the next one; the plan held more items before. */
static void an_item_goes_to_several_ranks(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank(), last = (rank + size - 1) % size;
    int item[MORE], dest[MORE], n = 0;
    for (int i = 0; i < N; i++) dest[i] = rank;
    struct par_exchange *x = par_exchange_renew(NULL, N, NULL, dest);
    assert_int_equal(par_exchange_count(x), N);
    for (int r = 0; r < size; r++, n++) item[n] = 0, dest[n] = r;
    item[n] = 1, dest[n++] = (rank + 1) % size;
    x = par_exchange_renew(x, n, item, dest);
    assert_int_equal(par_exchange_count(x), size + 1);
    const double mine[2] = {10 + rank, 20 + rank};
    double served[MORE];
    par_exchange_forward(x, mine, served, sizeof *mine);
    int k = 0;
    for (int r = 0; r < size; r++) {
        check_equal(served[k++], 10 + r);
        if (r == last) check_equal(served[k++], 20 + r);
    }
    par_exchange_free(x);
}

static void nothing_is_exchanged(void **state) {
    (void)state;
    const int dest[2] = {-1, -1};
    struct par_exchange *x = par_exchange_new(2, dest);
    double mine[2] = {1, 2}, served[1] = {3};
    par_exchange_forward(x, mine, served, sizeof *mine);
    par_exchange_backward(x, served, mine, sizeof *mine);
    assert_int_equal(par_exchange_count(x), 0);
    check_equal(mine[0], 1);
    check_equal(mine[1], 2);
    check_equal(served[0], 3);
    par_exchange_free(x);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(items_go_and_come_back),
                                       cmocka_unit_test(an_item_goes_to_several_ranks),
                                       cmocka_unit_test(nothing_is_exchanged)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
