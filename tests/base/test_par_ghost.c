/* Ghosts hold the values of the items' owners, in the order in which they were asked for. */
#include "base/par.h"
#include "base/par_ghost.h"
#include "tests/check.h"

enum { RANKS_MAX = 8, OWN_MAX = 3 + RANKS_MAX, ALL_MAX = RANKS_MAX * OWN_MAX };

/* Rank r owns 3 + r items, rank 1 none. */
struct division {
    long first[RANKS_MAX + 1], id[ALL_MAX]; /* id: those of other ranks, backwards */
    int own, n;
};

static struct division division(void) {
    struct division d = {.own = 0};
    const int size = par_size(), rank = par_rank();
    for (int r = 0; r < size; r++) d.first[r + 1] = d.first[r] + (r == 1 ? 0 : 3 + r);
    d.own = (int)(d.first[rank + 1] - d.first[rank]);
    for (long i = d.first[size] - 1; i >= 0; i--)
        if (i < d.first[rank] || i >= d.first[rank + 1]) d.id[d.n++] = i;
    return d;
}

static void ghosts_are_the_owners_values(void **state) {
    (void)state;
    const struct division d = division();
    double a[ALL_MAX], b[ALL_MAX], *const field[2] = {a, b};
    struct par_ghost *g = par_ghost_new(d.first, d.n, d.id);
    for (int turn = 0; turn < 3; turn++) {
        for (int i = 0; i < d.own + d.n; i++) a[i] = b[i] = NAN;
        for (int i = 0; i < d.own; i++) {
            a[i] = 100 * turn + (double)d.first[par_rank()] + i;
            b[i] = -2 * a[i];
        }
        par_ghost_update(g, 1 + turn % 2, field, d.own); /* one field and two in turn */
        struct record {
            long id;
            char letter;
        } record[ALL_MAX];
        for (int i = 0; i < d.own; i++) record[i] = (struct record){d.first[par_rank()] + i, (char)('a' + i % 7)};
        par_ghost_update_records(g, sizeof *record, record, d.own);
        for (int k = 0; k < d.n && par_size() > 1; k++) check_equal(record[d.own + k].id, d.id[k]);
        for (int k = 0; k < d.n; k++) {
            check_equal(a[d.own + k], 100 * turn + (double)d.id[k]);
            if (turn % 2) check_equal(b[d.own + k], -2 * a[d.own + k]);
            if (turn % 2 == 0) assert_true(isnan(b[d.own + k]));
        }
    }
    par_ghost_free(g);
}

/* The adjoint: <update x, y> = <x, add y>, and each owner gets the sum of its copies. */
static void values_are_given_back(void **state) {
    (void)state;
    const struct division d = division();
    double a[ALL_MAX], b[ALL_MAX], *const field[2] = {a, b};
    struct par_ghost *g = par_ghost_new(d.first, d.n, d.id);
    for (int i = 0; i < d.own + d.n; i++) {
        const double id = i < d.own ? (double)(d.first[par_rank()] + i) : (double)d.id[i - d.own];
        a[i] = i < d.own ? 1000 * id : id;
        b[i] = i < d.own ? 0 : 0.5;
    }
    par_ghost_add(g, 2, field, d.own);
    for (int i = 0; i < d.own; i++) {
        const double id = (double)(d.first[par_rank()] + i), copies = par_size() - 1;
        check_equal(a[i], 1000 * id + copies * id);
        check_equal(b[i], 0.5 * copies);
    }
    par_ghost_free(g);
}

/* The values at begin are sent; the ghosts are not to change before end. */
static void the_values_at_begin_are_sent(void **state) {
    (void)state;
    const struct division d = division();
    double a[ALL_MAX], *const field[1] = {a};
    struct par_ghost *g = par_ghost_new(d.first, d.n, d.id);
    par_ghost_end(g); /* nothing was begun */
    for (int i = 0; i < d.own + d.n; i++) a[i] = i < d.own ? (double)d.first[par_rank()] + i : -1;
    par_ghost_begin(g, 1, field, d.own);
    for (int i = 0; i < d.own; i++) a[i] = -7;
    for (int k = 0; k < d.n; k++) check_equal(a[d.own + k], -1);
    par_ghost_end(g);
    for (int i = 0; i < d.own; i++) check_equal(a[i], -7);
    for (int k = 0; k < d.n; k++) check_equal(a[d.own + k], (double)d.id[k]);
    par_ghost_free(g);
}

static void bytes_arrive_too(void **state) {
    (void)state;
    const struct division d = division();
    unsigned char a[ALL_MAX] = {0};
    struct par_ghost *g = par_ghost_new(d.first, d.n, d.id);
    for (int i = 0; i < d.own; i++) a[i] = (unsigned char)(200 + d.first[par_rank()] + i);
    par_ghost_update_bytes(g, a, d.own);
    for (int k = 0; k < d.n; k++) assert_int_equal(a[d.own + k], (unsigned char)(200 + d.id[k]));
    par_ghost_free(g);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ghosts_are_the_owners_values), cmocka_unit_test(values_are_given_back),
        cmocka_unit_test(the_values_at_begin_are_sent), cmocka_unit_test(bytes_arrive_too)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
