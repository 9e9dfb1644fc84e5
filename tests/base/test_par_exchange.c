/* Items arrive at the ranks that serve them, by rank and in order, and come back to their places. */
#include "base/par.h"
#include "base/par_count.h"
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

/* Rounds back to back, each with a pattern and numbers of its own: a rank that has finished one begins the next while
 * others still receive. In turn: all to one rank; one rank to all; the first half to the second; everyone to some. */
static void plans_follow_each_other(void **state) {
    (void)state;
    enum { ROUNDS = 400, MOST = 7 };
    const int size = par_size(), rank = par_rank();
    struct par_exchange *x = NULL;
    int dest[32 * MOST];
    assert_true(size <= 32);
    for (int round = 0; round < ROUNDS; round++) {
        int n = 0, expected = 0;
        for (int r = 0; r < size; r++) {
            const int goes[4] = {r == round % size, rank == round % size, 2 * rank < size && 2 * r >= size,
                                 (rank + 2 * r + round) % 3 == 0};
            const int comes[4] = {rank == round % size, r == round % size, 2 * r < size && 2 * rank >= size,
                                  (r + 2 * rank + round) % 3 == 0};
            for (int k = 0; k < (round + rank) % MOST && goes[round % 4]; k++) dest[n++] = r;
            expected += comes[round % 4] ? (round + r) % MOST : 0;
        }
        x = par_exchange_renew(x, n, NULL, dest);
        assert_int_equal(par_exchange_count(x), expected);
    }
    par_exchange_free(x);
}

/* Two plans renewed in turn do not take each other's messages; a message of a plan is one to each rank that gets items.
 */
static void plans_are_told_to_those_that_get_items(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank(), is_last = rank == size - 1;
    struct par_exchange *a = NULL, *b = NULL;
    int dest[2] = {size - 1, size - 1};
    const struct par_count before = par_count_of(PAR_COUNT_EXCHANGE);
    for (int round = 0; round < 50; round++) {
        a = par_exchange_renew(a, 2, NULL, dest);
        b = par_exchange_renew(b, is_last, NULL, &(int){0});
        assert_int_equal(par_exchange_count(a), is_last ? 2 * size : 0);
        assert_int_equal(par_exchange_count(b), rank == 0);
    }
    const struct par_count now = par_count_of(PAR_COUNT_EXCHANGE);
    assert_int_equal(now.messages - before.messages, size > 1 ? 50 : 0);
    assert_int_equal(now.collectives - before.collectives, size > 1 ? 100 : 0);
    assert_int_equal(now.bytes - before.bytes, size > 1 ? 200 : 0);
    par_exchange_free(a);
    par_exchange_free(b);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(items_go_and_come_back), cmocka_unit_test(an_item_goes_to_several_ranks),
        cmocka_unit_test(nothing_is_exchanged), cmocka_unit_test(plans_follow_each_other),
        cmocka_unit_test(plans_are_told_to_those_that_get_items)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
