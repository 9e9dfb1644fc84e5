/* Counted messages and bytes equal those of exchanges known by hand. */
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_exchange.h"
#include "base/par_ghost.h"
#include "base/par_halo.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

/* messages, collectives, bytes of a kind since the last call. */
static void assert_sent(enum par_count_kind kind, long messages, long collectives, long bytes) {
    static struct par_count last[PAR_COUNT_KINDS];
    const struct par_count now = par_count_of(kind);
    assert_int_equal(now.messages - last[kind].messages, messages);
    assert_int_equal(now.collectives - last[kind].collectives, collectives);
    assert_int_equal(now.bytes - last[kind].bytes, bytes);
    last[kind] = now;
}

/* Three items of 16 bytes to the next rank, one to this one, and back; the item that stays is not counted. */
static void exchange(void **state) {
    (void)state;
    const int size = par_size(), next = (par_rank() + 1) % size, crosses = size > 1;
    const int dest[4] = {next, par_rank(), next, next};
    double mine[4][2] = {{0}}, served[4][2];
    assert_sent(PAR_COUNT_EXCHANGE, 0, 0, 0);
    struct par_exchange *x = par_exchange_new(4, dest);
    assert_sent(PAR_COUNT_EXCHANGE, crosses, crosses, crosses * 4L); /* how many, to the next rank; a barrier */
    par_exchange_forward(x, mine, served, 16);
    assert_sent(PAR_COUNT_EXCHANGE, crosses, 0, crosses * 48L);
    par_exchange_backward(x, served, mine, 8);
    assert_sent(PAR_COUNT_EXCHANGE, crosses, 0, crosses * 24L);
    par_exchange_free(x);
}

/* Each rank owns five ids and wants two of the next rank's: what it sends are the two that the rank before wants. */
static void ghosts(void **state) {
    (void)state;
    const int size = par_size();
    if (size == 1) return;
    long first[5], id[2];
    for (int r = 0; r <= size; r++) first[r] = 5L * r;
    for (int k = 0; k < 2; k++) id[k] = first[(par_rank() + 1) % size] + k;
    assert_sent(PAR_COUNT_EXCHANGE, 0, 0, 0);
    struct par_ghost *g = par_ghost_new(first, 2, id);
    assert_sent(PAR_COUNT_EXCHANGE, 1, 1, 4); /* its plan */
    const struct par_count made = par_count_of(PAR_COUNT_GHOST);
    double a[7] = {0}, b[7] = {0};
    par_ghost_update(g, 2, (double *const[]){a, b}, 5);
    const struct par_count now = par_count_of(PAR_COUNT_GHOST);
    assert_int_equal(now.messages - made.messages, 1);
    assert_int_equal(now.bytes - made.bytes, 2 * 2 * 8);
    par_ghost_free(g);
}

/* 6 x 4 x 5 cells a rank, ranks along z, two fields, one layer, periodic: planes of 8 x 6 cells, ghosts included, both
 * ways. */
static void halo(void **state) {
    (void)state;
    const int size = par_size();
    const struct par_halo_input in = {.m = {6, 4, 5},
                                      .halo = 1,
                                      .ranks = {1, 1, size},
                                      .periodic = {1, 1, 1},
                                      .first = 48 + 8 + 1,
                                      .row = 8,
                                      .plane = 48};
    struct par_halo *h = par_halo_new(&in);
    double *a = calloc(8 * 6 * 7, sizeof *a), *b = calloc(8 * 6 * 7, sizeof *b);
    assert_sent(PAR_COUNT_HALO, 0, 0, 0);
    par_halo_fill(h, 2, (double *const[]){a, b}, 1);
    assert_sent(PAR_COUNT_HALO, size > 1 ? 2 : 0, 0, size > 1 ? 2 * 2 * 8 * 6 * 8 : 0);
    free(a);
    free(b);
    par_halo_free(h);
}

static void reductions(void **state) {
    (void)state;
    const int many = par_size() > 1;
    double value[3] = {0};
    assert_sent(PAR_COUNT_REDUCTION, 0, 0, 0);
    par_sum_array(value, 3);
    par_max(1);
    assert_sent(PAR_COUNT_REDUCTION, 0, 2 * many, 32 * many);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(exchange), cmocka_unit_test(ghosts), cmocka_unit_test(halo),
                                       cmocka_unit_test(reductions)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
