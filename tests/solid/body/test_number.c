/* Global ids: how ranks divide them, and how a rank finds its own copy of one. */
#include "base/par.h"
#include "solid/body/number.h"
#include "solid/body/sites.h"
#include "tests/check.h"

/* Of n points, which all cost the same, rank r has those from n r/size on, rounded up; of two bodies too. */
static void equal_shares(void **state) {
    (void)state;
    const int size = par_size();
    const long count[][2] = {{1, 0}, {7, 0}, {100, 0}, {3, 4}, {0, 5}, {1000, 1}};
    for (size_t k = 0; k < sizeof count / sizeof count[0]; k++) {
        const long n = count[k][0] + count[k][1];
        struct solid_sites a = {.count = count[k][0]}, b = {.count = count[k][1], .first = count[k][0]};
        long first[65];
        solid_number_divide((struct solid_sites *const[]){&a, &b}, 2, 1, first);
        for (int r = 0; r <= size; r++) assert_int_equal(first[r], (n * r + size - 1) / size);
    }
}

/* Rows of a lattice are not cut, and cost as much as their sites where bonds are lists. A full row and seven with one
 * site each, whose ids are 0-7, 8, .. 14: with equal rows a half is four rows, by sites it is seven and a half sites.
 */
static void rows_are_whole(void **state) {
    (void)state;
    uint8_t bits[2 * SOLID_BRICK] = {1, 1, 1, 1, 1, 1, [SOLID_BRICK] = 255, [2 * SOLID_BRICK - 1] = 1};
    long brick[2] = {9, 0}, first[65]; /* the second brick is numbered first */
    const long start[8] = {0, 8, 9, 10, 11, 12, 13, 14};
    int order[2] = {1, 0};
    struct solid_sites t = {
        .is_lattice = 1, .bricks = {2, 1, 1}, .ordered = 2, .count = 15, .bits = bits, .start = brick, .order = order};
    const int size = par_size();
    solid_number_divide((struct solid_sites *const[]){&t}, 1, 0, first);
    for (int r = 0; r <= size; r++) assert_int_equal(first[r], r == size ? 15 : start[(8 * r + size - 1) / size]);
    solid_number_divide((struct solid_sites *const[]){&t}, 1, 1, first);
    for (int r = 1; r < size; r++) {
        const int sites = (15 * r + size - 1) / size; /* before it, at the least */
        assert_int_equal(first[r], sites <= 8 ? 8 : sites);
    }
    assert_int_equal(first[size], 15);
}

static void own_ones_then_ghosts(void **state) {
    (void)state;
    long ghost[] = {3, 8, 9, 20, 31};
    struct solid_numbering numbering = {.from = 10, .to = 14, .ghosts = 5, .ghost_id = ghost};
    for (long id = 10; id < 14; id++) assert_int_equal(solid_number_local(&numbering, id), id - 10);
    for (int k = 0; k < 5; k++) assert_int_equal(solid_number_local(&numbering, ghost[k]), 4 + k);
    const long strangers[] = {0, 4, 14, 19, 32};
    for (int k = 0; k < 5; k++) assert_int_equal(solid_number_local(&numbering, strangers[k]), -1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(equal_shares), cmocka_unit_test(rows_are_whole),
                                       cmocka_unit_test(own_ones_then_ghosts)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
