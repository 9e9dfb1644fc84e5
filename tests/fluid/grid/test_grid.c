/* The grid's pieces: every cell is one rank's, places are found, rows start cache lines. */
#include "fluid/grid/grid.h"
#include "tests/fluid/fluid_case.h"

#include "tests/check.h"

static const int cells[3] = {13, 17, 19}, periodic[3] = {1, 1, 0};
static const double length[3] = {1.3, 3.4, 0.95};

/* The pieces' volumes make up the domain, and the middle of each of its cells is a rank's own: with equal numbers,
 * no two share one. */
static void pieces_make_the_domain(void **state) {
    (void)state;
    for (int halo = 1; halo <= 3; halo += 2) {
        struct fluid_grid *g = fluid_grid_new(cells, length, periodic, halo, NULL);
        long mine = 0;
        assert_int_equal(g->ranks[0], 1);
        assert_int_equal(g->ranks[1] * g->ranks[2], par_size());
        for (int d = 0; d < 3; d++) check_relative(g->d[d], length[d] / cells[d], 1e-15);
        for (int k = 0; k < cells[2]; k++)
            for (int j = 0; j < cells[1]; j++)
                for (int i = 0; i < cells[0]; i++) {
                    const double x[3] = {(i + 0.5) * g->d[0], (j + 0.5) * g->d[1], (k + 0.5) * g->d[2]};
                    const int at[3] = {i - g->lo[0], j - g->lo[1], k - g->lo[2]};
                    int inside = 1;
                    for (int d = 0; d < 3; d++) inside &= at[d] >= 0 && at[d] < g->m[d];
                    assert_int_equal(fluid_grid_rank_of(g, x) == par_rank(), inside);
                    mine += inside;
                }
        assert_int_equal(mine, (long)g->m[0] * g->m[1] * g->m[2]);
        assert_int_equal(par_sum_long(mine), (long)cells[0] * cells[1] * cells[2]);
        fluid_grid_free(g);
    }
}

/* Places beyond a periodic side come back in; beyond a wall they are nobody's; the far end belongs to the last cell.
 * */
static void places_at_the_ends(void **state) {
    (void)state;
    struct fluid_grid *g = fluid_grid_new(cells, length, periodic, 1, NULL);
    const double z = length[2];
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, z - 1e-9}), par_size() - 1);
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, z}), par_size() - 1);
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, z + 1e-9}), -1);
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, 0}), 0);
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, -1e-9}), -1);
    assert_int_equal(fluid_grid_rank_of(g, (double[]){0.1, 0.1, NAN}), -1);
    for (int turns = -3; turns <= 3; turns++) {
        const double x[3] = {0.1 + turns * length[0], 0.7 - 2 * turns * length[1], 0.3}, here[3] = {0.1, 0.7, 0.3};
        assert_int_equal(fluid_grid_rank_of(g, x), fluid_grid_rank_of(g, here));
    }
    fluid_grid_free(g);
}

/* No two cells, ghosts with them, share a place in the array; eight at a time may run over a row's last cell without
 * meeting the next row's. */
static void places_in_the_array(void **state) {
    (void)state;
    for (int halo = 1; halo <= 3; halo++) {
        struct fluid_grid *g = fluid_grid_new(cells, length, periodic, halo, NULL);
        size_t before = 0;
        for (int k = -halo; k < g->m[2] + halo; k++)
            for (int j = -halo; j < g->m[1] + halo; j++) {
                assert_int_equal(fluid_grid_at(g, 0, j, k) % FLUID_GRID_LANES, 0);
                const size_t first = fluid_grid_at(g, -halo, j, k), end = fluid_grid_at(g, g->m[0] + halo, j, k);
                check_at_least(first, before);
                check_at_most(end, g->size);
                before = end;
                const size_t over =
                    fluid_grid_at(g, (g->m[0] + FLUID_GRID_LANES - 1) / FLUID_GRID_LANES * FLUID_GRID_LANES, j, k);
                if (j + 1 < g->m[1] + halo) check_at_most(over, fluid_grid_at(g, -halo, j + 1, k));
            }
        fluid_grid_free(g);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pieces_make_the_domain), cmocka_unit_test(places_at_the_ends),
                                       cmocka_unit_test(places_in_the_array)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
