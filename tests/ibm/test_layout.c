/* The order that markers are put in: each is counted once, lists follow one another slab by slab, and slabs that
 * are not neighbours share no plane. */
#include "base/par.h"
#include "ibm/state.h"
#include "tests/check.h"
#include "tests/ibm/scattered.h"

#include <stdlib.h>

/* walls: across y and z. */
static struct fluid *box(int walls) {
    struct fluid_input in = {
        .n = {12, 12, 14}, .length = {0.6, 0.6, 0.7}, .density = 1, .viscosity = 0.01, .immersed = 1};
    for (int side = 0; side < 2 && walls; side++) in.side[1][side].type = in.side[2][side].type = FLUID_WALL;
    return fluid_new(&in);
}

static void cell_of(const struct ibm *b, int h, int cell[3]) {
    const double *item = b->route.served + (size_t)b->arrival[h] * IBM_ITEM;
    for (int d = 0; d < 3; d++) cell[d] = ibm_cell(b->grid, d, item[d]);
}

static struct ibm *laid_out(struct fluid *f) {
    struct ibm *b = ibm_new(f, 1);
    static double x[3][SCATTERED], volume[SCATTERED];
    const int n = scattered(fluid_grid_of(f), x, volume);
    const double *const at[3] = {x[0], x[1], x[2]};
    ibm_markers_set(b, n, at, at, volume);
    return b;
}

static void each_is_counted_once(void **state) {
    (void)state;
    for (int walls = 0; walls < 2; walls++) {
        struct fluid *f = box(walls);
        struct ibm *b = laid_out(f);
        char *seen = calloc((size_t)b->served + 1, 1);
        long mine = b->inner;
        assert_int_equal(b->inner + b->edges, b->served);
        check_above(b->inner, 0);
        check_above(b->near_edges, 0);
        if (!walls) check_above(b->edges, b->near_edges);
        for (int h = 0; h < b->served; h++) {
            int cell[3], rank[IBM_SHARERS], me = 0;
            cell_of(b, h, cell);
            assert_int_equal(seen[b->arrival[h]]++, 0);
            assert_int_equal(ibm_layout_is_inner(b, cell), h < b->inner);
            const int sharers = ibm_share_ranks(b, cell, rank);
            for (int k = 0; k < sharers; k++) me += rank[k] == par_rank();
            assert_int_equal(me, 1);
            for (int k = 1; k < sharers; k++) check_above(rank[k], rank[k - 1]);
            if (h < b->inner)
                assert_int_equal(sharers, 1);
            else
                mine += b->edge[h - b->inner].mine;
        }
        assert_int_equal(par_sum_long(mine), SCATTERED);
        free(seen);
        ibm_free(b);
        fluid_free(f);
    }
}

/* In each list a slab's range begins where the one before ends, and holds what is of the slab. */
static void slab_by_slab(void **state) {
    (void)state;
    for (int walls = 0; walls < 2; walls++) {
        struct fluid *f = box(walls);
        struct ibm *b = laid_out(f);
        const int end[IBM_LISTS] = {b->inner, b->near_edges, ibm_slab_first(b, IBM_FAR_PIECES, 0), b->pieces};
        for (enum ibm_list list = IBM_INNER; list < IBM_LISTS; list++) {
            assert_int_equal(ibm_slab_first(b, list, 0), list == IBM_FAR_PIECES ? end[IBM_NEAR_PIECES] : 0);
            assert_int_equal(ibm_slab_first(b, list, b->slabs), end[list]);
        }
        for (int s = 0; s < b->slabs; s++) {
            for (int h = ibm_slab_first(b, IBM_INNER, s); h < ibm_slab_first(b, IBM_INNER, s + 1); h++) {
                int cell[3];
                cell_of(b, h, cell);
                assert_int_equal(ibm_layout_slab_of(b, cell[2] - b->grid->lo[2]), s);
            }
            for (int far = 0; far < 2; far++) {
                const enum ibm_list list = far ? IBM_FAR_PIECES : IBM_NEAR_PIECES;
                for (int p = ibm_slab_first(b, list, s); p < ibm_slab_first(b, list, s + 1); p++) {
                    const struct ibm_edge *e = &b->edge[b->piece[p].edge];
                    int plane[IBM_PIECES], found = 0;
                    const int pieces = ibm_edge_planes(b, e->cell, plane);
                    assert_int_equal(pieces, e->pieces);
                    assert_int_equal(b->piece[p].edge >= b->near_edges, far);
                    for (int q = 0; q < pieces; q++) found += e->piece[q] == p && ibm_layout_slab_of(b, plane[q]) == s;
                    assert_int_equal(found, 1);
                }
            }
            for (int e = ibm_slab_first(b, IBM_NEAR, s); e < ibm_slab_first(b, IBM_NEAR, s + 1); e++)
                for (int q = 0; q < b->edge[e].pieces; q++) {
                    check_at_least(b->edge[e].piece[q], ibm_slab_first(b, IBM_NEAR_PIECES, s));
                    check_below(b->edge[e].piece[q], ibm_slab_first(b, IBM_NEAR_PIECES, s + 1));
                }
        }
        ibm_free(b);
        fluid_free(f);
    }
}

/* A block reaches two planes before its own and one behind: of slabs s and s + 2 the nearest blocks do not meet. */
static void slabs_apart_do_not_touch(void **state) {
    (void)state;
    struct fluid *f = box(0);
    struct ibm *b = ibm_new(f, 1);
    for (int low = 0; low < b->grid->m[2]; low++)
        for (int high = low; high < b->grid->m[2]; high++)
            if (ibm_layout_slab_of(b, high) - ibm_layout_slab_of(b, low) > 1)
                check_above(high - IBM_BEFORE, low + IBM_BEHIND);
    check_at_least(par_size() == 1 ? ibm_layout_slab_of(b, b->grid->m[2] - 1) : 2, 2);
    ibm_free(b);
    fluid_free(f);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_is_counted_once), cmocka_unit_test(slab_by_slab),
                                       cmocka_unit_test(slabs_apart_do_not_touch)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
