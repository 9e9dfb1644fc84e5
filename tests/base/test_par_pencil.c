/* A transpose puts each value to its place in the other pencil, and the reverse one back. */
#include "base/par.h"
#include "base/par_pencil.h"
#include "base/par_piece.h"
#include "base/threads.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { NX = 7, NY = 5, NZ = 6, EXTRA = 1, CAPACITY = NX * NY * (NZ + EXTRA) };

static double value_of(int x, int y, int z) { return 100 * z + 10 * y + x; }

static void transposes(int across, int along) {
    const struct par_pencil_input in = {.n = {NX, NY, NZ}, .ranks = {1, across, along}, .extra = EXTRA};
    const int c_y = par_rank() % across, c_z = par_rank() / across;
    const int y0 = par_piece_low(NY, across, c_y), z0 = par_piece_low(NZ, along, c_z);
    struct par_pencil *p = par_pencil_new(&in);
    int x_pencil[3], y_pencil[3];
    par_pencil_shape(p, x_pencil, y_pencil);
    const int x0 = par_pencil_low(p), planes = x_pencil[2] + EXTRA;
    assert_int_equal(x_pencil[0], NX);
    assert_int_equal(x_pencil[1], par_piece_low(NY, across, c_y + 1) - y0);
    assert_int_equal(x_pencil[2], par_piece_low(NZ, along, c_z + 1) - z0);
    assert_int_equal(y_pencil[1], NY);
    assert_int_equal(y_pencil[2], x_pencil[2]);
    assert_int_equal(par_sum_long(y_pencil[0]), NX * along);
    assert_int_equal(par_pencil_same(p), across == 1);
    if (par_pencil_same(p)) { /* no transpose exists */
        assert_memory_equal(x_pencil, y_pencil, sizeof x_pencil);
        par_pencil_free(p);
        return;
    }
    double xs[CAPACITY], ys[CAPACITY], back[CAPACITY];
    for (int z = 0; z < planes; z++)
        for (int y = 0; y < x_pencil[1]; y++)
            for (int x = 0; x < NX; x++) xs[(z * x_pencil[1] + y) * NX + x] = value_of(x, y0 + y, z0 + z);
    par_pencil_forward(p, planes, xs, ys);
    for (int z = 0; z < planes; z++)
        for (int y = 0; y < NY; y++)
            for (int x = 0; x < y_pencil[0]; x++)
                check_equal(ys[(z * NY + y) * y_pencil[0] + x], value_of(x0 + x, y, z0 + z));
    for (int i = 0; i < CAPACITY; i++) back[i] = NAN;
    par_pencil_backward(p, planes, ys, back);
    for (int i = 0; i < planes * x_pencil[1] * NX; i++) check_equal(back[i], xs[i]);
    par_pencil_free(p);
}

static void ranks_along_y(void **state) {
    (void)state;
    transposes(par_size(), 1);
}

static void ranks_along_z(void **state) {
    (void)state;
    transposes(1, par_size());
}

static void ranks_along_both(void **state) {
    (void)state;
    if (par_size() % 2 == 0) transposes(2, par_size() / 2);
}

/* Pencils that are large enough for the threads to share: as on one thread, and back again. */
static void threads_share_the_copies(void **state) {
    (void)state;
    enum { X = 72, Y = 67, Z = 19 };
    const struct par_pencil_input in = {.n = {X, Y, Z}, .ranks = {1, par_size(), 1}};
    struct par_pencil *p = par_pencil_new(&in);
    const size_t capacity = (size_t)X * Y * Z, bytes = capacity * sizeof(double);
    double *xs = calloc(capacity, sizeof *xs), *one = calloc(capacity, sizeof *one), *ys = calloc(capacity, sizeof *ys),
           *back = calloc(capacity, sizeof *back);
    int x_pencil[3], y_pencil[3];
    par_pencil_shape(p, x_pencil, y_pencil);
    for (int i = 0; i < X * x_pencil[1] * Z; i++) xs[i] = i + 1e6 * par_rank();
    if (par_size() <= 4) assert_true(X * x_pencil[1] * Z > PAR_PENCIL_SHARED);
    for (int threads = 1; threads <= 4 && !par_pencil_same(p); threads++) {
        threads_set(threads);
        memset(ys, 0, bytes);
        memset(back, 0, bytes);
        par_pencil_forward(p, Z, xs, ys);
        if (threads == 1) memcpy(one, ys, bytes);
        assert_memory_equal(ys, one, bytes);
        par_pencil_backward(p, Z, ys, back);
        assert_memory_equal(back, xs, bytes);
    }
    threads_set(1);
    for (int i = 0; i < 4; i++) free(((double *[]){xs, one, ys, back})[i]);
    par_pencil_free(p);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(ranks_along_y), cmocka_unit_test(ranks_along_z),
                                       cmocka_unit_test(ranks_along_both), cmocka_unit_test(threads_share_the_copies)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
