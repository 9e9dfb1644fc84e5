/* Pairs of ranks exchange equal pieces, each piece with the right rank. */
#include "base/par.h"
#include "base/par_swap.h"
#include "tests/check.h"

enum { RANKS_MAX = 8, CAPACITY = 1000 };

/* Item i, number c, of the piece that a rank sends to another. */
static double value_of(int from, int to, int i, int c) { return 1000 * from + 100 * to + 10 * i + c; }

/* Ranks r and s share r + s items of the given number of doubles. backwards: the pieces by falling rank. */
static void exchange(struct par_swap *s, int doubles, int backwards) {
    const int size = par_size(), me = par_rank();
    int rank[RANKS_MAX], count[RANKS_MAX], peers = 0, n = 0;
    double send[CAPACITY], received[CAPACITY];
    for (int k = 0; k < size; k++) {
        const int r = backwards ? size - 1 - k : k;
        if (r == me) continue;
        rank[peers] = r;
        count[peers++] = r + me;
        for (int i = 0; i < r + me; i++)
            for (int c = 0; c < doubles; c++) send[n++] = value_of(me, r, i, c);
    }
    for (int k = 0; k < CAPACITY; k++) received[k] = -1;
    par_swap_set(s, peers, rank, count);
    par_swap(s, send, received, doubles);
    n = 0;
    for (int p = 0; p < peers; p++)
        for (int i = 0; i < count[p]; i++)
            for (int c = 0; c < doubles; c++) check_equal(received[n++], value_of(rank[p], me, i, c));
    check_equal(received[n], -1);
}

static void pieces_go_to_their_ranks(void **state) {
    (void)state;
    struct par_swap *s = par_swap_new();
    exchange(s, 1, 0);
    exchange(s, 3, 1);
    par_swap_free(s);
}

/* Ranks that were set before are forgotten. */
static void no_ranks_no_messages(void **state) {
    (void)state;
    struct par_swap *s = par_swap_new();
    const double send = 1;
    double received = 2;
    par_swap(s, &send, &received, 1);
    exchange(s, 1, 0);
    par_swap_set(s, 0, NULL, NULL);
    par_swap(s, &send, &received, 1);
    check_equal(received, 2);
    par_swap_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pieces_go_to_their_ranks),
                                       cmocka_unit_test(no_ranks_no_messages)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
