/* Pores that lead through: by hand, straight and slanted, and random ones on any number of ranks. Numbers of pore
 * cells, and how many meet across the sides. */
#include "stokes/pieces.h"
#include "tests/stokes/make.h"

static const struct stokes_input periodic = {.d = {1, 1, 1}, .tolerance = 1e-4};

/* The pieces of a box. */
static struct stokes_pieces pieces_of(const int n[3], make_is_pore *is_pore, const void *with) {
    struct stokes_mask *m = make_mask(n, is_pore, with);
    const struct stokes_grid g = {.in = periodic, .mask = m, .axis = -1};
    struct stokes_cells *c = stokes_cells_new(&g);
    struct stokes_pieces *p = stokes_pieces_new(c), found = *p;
    stokes_pieces_free(p);
    stokes_cells_free(c);
    stokes_mask_free(m);
    return found;
}

static int tube(const int at[3], const void *with) {
    (void)with;
    return at[1] == 2 && at[2] == 3;
}
static int two(const int at[3], const void *with) { return tube(at, with) || (at[1] == 5 && at[0] > 1 && at[2] == 1); }
/* Steps that rise by one cell along y for each along x. */
static int stair(const int at[3], const void *with) {
    (void)with;
    return at[2] == 0 && (at[0] == at[1] || at[0] == (at[1] + 1) % 6);
}
/* From the low side along x to the high side along y of the next period: neither side meets itself. */
static int bent(const int at[3], const void *with) {
    (void)with;
    return at[2] == 1 && ((at[1] == 2 && at[0] <= 4) || (at[0] == 4 && at[1] >= 2 && at[1] < 6));
}

static void by_hand(void **state) {
    (void)state;
    static const int n[3] = {7, 8, 9}, even[3] = {6, 6, 4};
    const struct stokes_pieces one = pieces_of(n, tube, NULL);
    check_equal(one.all, 1);
    check_equal(one.through, 1);
    check_equal(one.cells, 7);
    check_equal(one.percolates[0], 1);
    check_equal(one.percolates[1] + one.percolates[2], 0);
    const struct stokes_pieces more = pieces_of(n, two, NULL);
    check_equal(more.all, 2);
    check_equal(more.through, 1);
    check_equal(more.cells, 7);
    const struct stokes_pieces slanted = pieces_of(even, stair, NULL);
    check_equal(slanted.percolates[0], 1);
    check_equal(slanted.percolates[1], 1);
    check_equal(slanted.percolates[2], 0);
    const struct stokes_pieces dead = pieces_of(even, bent, NULL);
    check_equal(dead.through, 0);
    check_equal(dead.percolates[0] + dead.percolates[1] + dead.percolates[2], 0);
}

/* The numbers are those of a flood fill that keeps the period of each cell, written by hand in another language. */
static void noise(void **state) {
    (void)state;
    static const int n[3] = {19, 17, 23};
    static const struct {
        double share;
        long all, through, cells;
        int percolates;
    } known[] = {{0.25, 547, 0, 0, 0}, {0.35, 301, 1, 1969, 7}, {0.6, 15, 1, 4452, 7}};
    for (int q = 0; q < 3; q++) {
        const struct stokes_pieces p = pieces_of(n, make_noise, &known[q].share);
        check_equal(p.all, known[q].all);
        check_equal(p.through, known[q].through);
        check_equal(p.cells, known[q].cells);
        check_equal(p.percolates[0] + 2 * p.percolates[1] + 4 * p.percolates[2], known[q].percolates);
    }
}

static void numbers(void **state) {
    (void)state;
    static const int n[3] = {130, 3, 5};
    const double share = 0.4;
    struct stokes_mask *m = make_mask(n, make_noise, &share);
    long count = 0, meets = 0;
    int next[3] = {-1, 0, 0};
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const int at[3] = {i, j, k};
                int found[3];
                check_equal(stokes_mask_is(m, i, j, k), make_noise(at, &share));
                if (!stokes_mask_is(m, i, j, k)) continue;
                check_equal(stokes_mask_number(m, i, j, k), count);
                stokes_mask_find(m, count++, found);
                stokes_mask_next(m, next);
                for (int c = 0; c < 3; c++) {
                    check_equal(found[c], at[c]);
                    check_equal(next[c], at[c]);
                }
            }
    check_equal(m->before[15], count);
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++) meets += stokes_mask_is(m, i, j, 0) && stokes_mask_is(m, i, j, 4);
    check_equal(stokes_mask_overlap(m, 2).both, meets);
    struct stokes_mask *longer = stokes_mask_extended(m, 0);
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++) {
            check_equal(stokes_mask_is(longer, 0, j, k), stokes_mask_is(m, 0, j, k));
            check_equal(stokes_mask_is(longer, 131, j, k), stokes_mask_is(m, 129, j, k));
            check_equal(stokes_mask_is(longer, 65, j, k), stokes_mask_is(m, 64, j, k));
        }
    stokes_mask_free(longer);
    stokes_mask_free(m);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_hand), cmocka_unit_test(noise), cmocka_unit_test(numbers)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
