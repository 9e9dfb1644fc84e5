/* Deposition of one cube and flood fill of one rank against results worked by hand. */
#include "base/par.h"
#include "coupling/medium/kernels.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { N = 4 };
static const int first[3] = {0, 0, 0}, last[3] = {N, N, N};

static double at(const double *f, int i, int j, int k) { return f[(k * N + j) * N + i]; }

static void test_unit_cube_on_lattice(void **state) {
    (void)state;
    double f[N * N * N] = {0};
    const double low[3] = {1, 2, 0}, high[3] = {2, 3, 1};
    medium_kernels_deposit(low, high, first, last, N, N * N, f);
    for (int k = 0; k < N; k++)
        for (int j = 0; j < N; j++)
            for (int i = 0; i < N; i++) check_equal(at(f, i, j, k), i == 1 && j == 2 && k == 0);
}

/* Offsets of 1/4, 1/2 and 0 share the cube as (3/4, 1/4) x (1/2, 1/2) x 1: exact in binary. */
static void test_offset_cube(void **state) {
    (void)state;
    double f[N * N * N] = {0};
    const double low[3] = {1.25, 0.5, 3}, high[3] = {2.25, 1.5, 4};
    medium_kernels_deposit(low, high, first, last, N, N * N, f);
    check_equal(at(f, 1, 0, 3), 0.375);
    check_equal(at(f, 2, 0, 3), 0.125);
    check_equal(at(f, 1, 1, 3), 0.375);
    check_equal(at(f, 2, 1, 3), 0.125);
    double sum = 0;
    for (int n = 0; n < N * N * N; n++) sum += f[n];
    check_equal(sum, 1);
}

/* Three cells wide: whole cells inside, parts at the rim. */
static void test_wide_box(void **state) {
    (void)state;
    double f[N * N * N] = {0};
    const double low[3] = {0.5, 0, 1}, high[3] = {3.5, 1, 2};
    medium_kernels_deposit(low, high, first, last, N, N * N, f);
    check_equal(at(f, 0, 0, 1), 0.5);
    check_equal(at(f, 1, 0, 1), 1);
    check_equal(at(f, 2, 0, 1), 1);
    check_equal(at(f, 3, 0, 1), 0.5);
}

static void test_outside_is_dropped(void **state) {
    (void)state;
    double f[N * N * N] = {0};
    const double low[3] = {-0.75, 3.5, 1}, high[3] = {0.25, 4.5, 2};
    medium_kernels_deposit(low, high, first, last, N, N * N, f);
    double sum = 0;
    for (int n = 0; n < N * N * N; n++) sum += f[n];
    check_equal(sum, 0.125);
    check_equal(at(f, 0, 3, 1), 0.125);
}

/* Sums on a 2x1x1 piece with one ghost: weights halve the first cell, the second is solid. */
static void test_sums(void **state) {
    (void)state;
    const int m[3] = {2, 1, 1};
    const ptrdiff_t row = 4, plane = 12;
    double f[36] = {0}, u[36] = {0}, v[36] = {0}, w[36] = {0};
    const size_t o = 12 + 4 + 1;
    f[o + 1] = 0.75;
    u[o - 1] = 2, u[o] = 4, u[o + 1] = 6; /* centres 3 and 5 */
    v[o - row] = 4, v[o] = 4;             /* 4 in the first */
    const double wx[2] = {0.5, 1}, one[1] = {1};
    const double *const weight[3] = {wx, one, one};
    check_equal(medium_kernels_sum_solid(m, row, plane, weight, f + o), 0.75);
    const struct medium_sums s = medium_kernels_sum_flow(m, row, plane, weight, f + o, u + o, v + o, w + o);
    check_equal(s.u[0], 0.5 * 3 + 5);
    check_equal(s.pore_u[0], 0.5 * 3);
    check_equal(s.pore_speed, 0.5 * 5);
}

/* x -->      # wall; the flood starts at S and must reach the five cells joined to it by faces, not x (corner only)
 *    . . # x
 *    S # . #
 *    . . . #     (one layer in z) */
static void test_flood(void **state) {
    (void)state;
    const char *map[3] = {"..#x", "S#.#", "...#"};
    const int m[3] = {4, 3, 1}, row = 6;
    uint8_t cell[6 * 5 * 3];
    memset(cell, MEDIUM_WALL, sizeof cell);
    int stack[12], n = 0;
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 4; i++) {
            const int a = (row * 5) + (j + 1) * row + i + 1;
            if (map[j][i] != '#') cell[a] = MEDIUM_PORE;
            if (map[j][i] == 'S') cell[a] = MEDIUM_FRONT, stack[n++] = a;
        }
    assert_int_equal(medium_kernels_flood(m, MEDIUM_FRONT, n, stack, cell), 6);
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 4; i++) {
            const uint8_t c = cell[(row * 5) + (j + 1) * row + i + 1];
            assert_int_equal(c, map[j][i] == '#' ? MEDIUM_WALL : map[j][i] == 'x' ? MEDIUM_PORE : MEDIUM_FRONT);
        }
    /* the second level floods only cells of the first one */
    stack[0] = (row * 5) + 3 * row + 3;
    cell[stack[0]] = MEDIUM_BOTH;
    assert_int_equal(medium_kernels_flood(m, MEDIUM_BOTH, 1, stack, cell), 6);
    assert_int_equal(cell[(row * 5) + row + 4], MEDIUM_PORE);
}

/* Pores at random: the same cells as by repeated looks at all neighbours. */
static void test_flood_of_random_pores(void **state) {
    (void)state;
    enum { X = 45, Y = 6, Z = 5, ROW = X + 2, PLANE = ROW * (Y + 2), ALL = PLANE * (Z + 2) };
    const int m[3] = {X, Y, Z}, neighbour[6] = {-1, 1, -ROW, ROW, -PLANE, PLANE};
    static uint8_t cell[ALL], plain[ALL];
    static int stack[X * Y * Z];
    uint32_t seed = 1;
    long most = 0;
    for (int walls = 1; walls < 10; walls++) { /* of ten cells */
        int n = 0;
        memset(cell, MEDIUM_WALL, sizeof cell);
        for (int k = 0; k < Z; k++)
            for (int j = 0; j < Y; j++)
                for (int i = 0; i < X; i++) {
                    const int at = (k + 1) * PLANE + (j + 1) * ROW + i + 1;
                    seed = seed * 1664525 + 1013904223;
                    const int pore = (int)(seed >> 16) % 10 >= walls;
                    cell[at] = pore ? MEDIUM_PORE : MEDIUM_WALL;
                    if (!pore || i != X / 2) continue;
                    cell[at] = MEDIUM_FRONT;
                    stack[n++] = at;
                }
        memcpy(plain, cell, sizeof cell);
        long reached = 0;
        for (long before = -1; before != reached;) {
            before = reached;
            for (int at = 0; at < ALL; at++)
                for (int b = 0; b < 6 && plain[at] == MEDIUM_PORE; b++) {
                    if (plain[at + neighbour[b]] != MEDIUM_FRONT) continue;
                    plain[at] = MEDIUM_FRONT;
                    reached++;
                }
        }
        assert_int_equal(medium_kernels_flood(m, MEDIUM_FRONT, n, stack, cell), reached);
        assert_memory_equal(cell, plain, sizeof cell);
        most = reached > most ? reached : most;
    }
    assert_true(most > X * Y * Z / 2);
}

/* Cells are set again only where the fraction says otherwise, and each row's open volume is that of the cells reached.
 */
static void test_compare_and_open(void **state) {
    (void)state;
    enum { M = 21 };
    double weight[M], fraction[M], sum = 0;
    uint8_t cell[M];
    for (int i = 0; i < M; i++) {
        weight[i] = i == 0 ? 0 : i == 1 ? 0.25 : 1;
        fraction[i] = i % 3 == 0 ? 0.75 : 0.125;
        cell[i] = i > 0 && i % 3 != 0 ? MEDIUM_BOTH : MEDIUM_WALL;
        if (cell[i] == MEDIUM_BOTH) sum += weight[i] * 0.875;
    }
    assert_int_equal(medium_kernels_compare(M, 1, weight, fraction, cell), 0);
    check_relative(medium_kernels_open(M, weight, fraction, cell), sum, 1e-14);
    fraction[17] = 0.75;
    fraction[18] = 0.25;
    assert_int_equal(medium_kernels_compare(M, 1, weight, fraction, cell), 1);
    for (int i = 0; i < M; i++)
        assert_int_equal(cell[i], i == 18 ? MEDIUM_PORE : i == 17 || i % 3 == 0 ? MEDIUM_WALL : MEDIUM_BOTH);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unit_cube_on_lattice),
        cmocka_unit_test(test_offset_cube),
        cmocka_unit_test(test_wide_box),
        cmocka_unit_test(test_outside_is_dropped),
        cmocka_unit_test(test_sums),
        cmocka_unit_test(test_flood),
        cmocka_unit_test(test_flood_of_random_pores),
        cmocka_unit_test(test_compare_and_open),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
