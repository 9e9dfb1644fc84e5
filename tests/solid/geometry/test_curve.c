/* Hilbert's curve: a brick that is aligned, of 2^k a side, is passed in one go, and each step is to a neighbour. */
#include "base/par.h"
#include "solid/geometry/curve.h"
#include "tests/check.h"

#include <stdlib.h>

enum { SIDE = 16, MOST = SIDE * SIDE * SIDE };

/* Of a brick of SIDE cells from a corner on: every key of the brick's range is there once, and neighbours in it are
 * neighbours in space. first: the key that the brick begins with. */
static uint64_t pass(const uint32_t *corner, int dim) {
    static uint32_t at[MOST][3];
    static char seen[MOST];
    const int cells = dim == 3 ? MOST : SIDE * SIDE;
    uint64_t first = UINT64_MAX;
    for (int n = 0; n < cells; n++) {
        const uint32_t x[3] = {corner[0] + (uint32_t)(n % SIDE), corner[1] + (uint32_t)(n / SIDE % SIDE),
                               dim == 3 ? corner[2] + (uint32_t)(n / SIDE / SIDE) : 0};
        const uint64_t key = solid_curve_key(x, dim);
        if (key < first) first = key;
    }
    for (int n = 0; n < cells; n++) seen[n] = 0;
    for (int n = 0; n < cells; n++) {
        const uint32_t x[3] = {corner[0] + (uint32_t)(n % SIDE), corner[1] + (uint32_t)(n / SIDE % SIDE),
                               dim == 3 ? corner[2] + (uint32_t)(n / SIDE / SIDE) : 0};
        const uint64_t place = solid_curve_key(x, dim) - first;
        check_below(place, cells);
        assert_int_equal(seen[place]++, 0);
        for (int c = 0; c < 3; c++) at[place][c] = x[c];
    }
    for (int n = 1; n < cells; n++) {
        long step = 0;
        for (int c = 0; c < 3; c++) step += labs((long)at[n][c] - (long)at[n - 1][c]);
        assert_int_equal(step, 1);
    }
    return first;
}

static void steps_to_neighbours(void **state) {
    (void)state;
    const uint32_t most = (1u << SOLID_CURVE_BITS) - SIDE;
    const uint32_t corner[4][3] = {
        {0, 0, 0}, {SIDE, 0, 3 * SIDE}, {48 * SIDE, 7 * SIDE, 1000 * SIDE}, {most, most, most}};
    for (int dim = 2; dim <= 3; dim++)
        for (int k = 0; k < 4; k++) {
            const uint64_t first = pass(corner[k], dim);
            assert_int_equal(first % (dim == 3 ? MOST : SIDE * SIDE), 0);
            if (k == 0) assert_int_equal(first, 0);
        }
}

/* From one aligned brick to the next the curve goes on: the brick that begins where the first ends touches it. */
static void ends_where_it_should(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) { /* all of the curve: from the origin to another corner along one edge */
        const uint32_t most = (1u << SOLID_CURVE_BITS) - 1;
        uint64_t last = 0;
        int ends = 0;
        for (int n = 0; n < 1 << dim; n++) {
            const uint32_t x[3] = {n & 1 ? most : 0, n & 2 ? most : 0, n & 4 ? most : 0};
            const uint64_t key = solid_curve_key(x, dim);
            if (key == (UINT64_C(1) << dim * SOLID_CURVE_BITS) - 1) {
                ends++;
                assert_int_equal((n & 1) + (n >> 1 & 1) + (n >> 2 & 1), 1);
            }
            if (key > last) last = key;
        }
        assert_int_equal(ends, 1);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(steps_to_neighbours), cmocka_unit_test(ends_where_it_should)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
