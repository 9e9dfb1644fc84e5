/* Halo exchange: each ghost is its owner's image, and adding back is the adjoint of filling. */
#include "base/par_halo.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <stdlib.h>

enum { NX = 9, NY = 13, NZ = 17, HALO = 3 };

static int wrap(int i, int n) { return ((i % n) + n) % n; }

static struct fluid_grid *grid(int px, int py, int pz) {
    return fluid_grid_new((int[3]){NX, NY, NZ}, (double[3]){1, 1, 1}, (int[3]){px, py, pz}, HALO, NULL);
}

static void fill_gives_images(void **state) {
    (void)state;
    for (int mask = 0; mask < 8; mask++)
        for (int layers = 1; layers <= HALO; layers++) {
            struct fluid_grid *g = grid(mask & 1, mask >> 1 & 1, mask >> 2 & 1);
            double *q[2] = {calloc(g->size, sizeof(double)), calloc(g->size, sizeof(double))};
            for (size_t n = 0; n < g->size; n++) q[0][n] = q[1][n] = 77;
            for (int f = 0; f < 2; f++)
                for (int k = 0; k < g->m[2]; k++)
                    for (int j = 0; j < g->m[1]; j++)
                        for (int i = 0; i < g->m[0]; i++)
                            q[f][fluid_grid_at(g, i, j, k)] = random_at(i, j + g->lo[1], k + g->lo[2], f);
            par_halo_fill(g->halos, 2, q, layers);
            for (int f = 0; f < 2; f++)
                for (int k = -HALO; k < g->m[2] + HALO; k++)
                    for (int j = -HALO; j < g->m[1] + HALO; j++)
                        for (int i = -HALO; i < g->m[0] + HALO; i++) {
                            const int at[3] = {i, j + g->lo[1], k + g->lo[2]}, local[3] = {i, j, k};
                            int outside = 0;
                            for (int d = 0; d < 3; d++) {
                                outside |= !g->periodic[d] && (at[d] < 0 || at[d] >= g->n[d]);
                                outside |= local[d] < -layers || local[d] >= g->m[d] + layers;
                            }
                            const double expected =
                                outside ? 77 : random_at(wrap(at[0], NX), wrap(at[1], NY), wrap(at[2], NZ), f);
                            check_equal(q[f][fluid_grid_at(g, i, j, k)], expected);
                        }
            free(q[0]);
            free(q[1]);
            fluid_grid_free(g);
        }
}

/* <fill a, b> = <a, add b> over all arrays, for a on the cells and b on cells and ghosts. */
static void add_is_adjoint(void **state) {
    (void)state;
    for (int mask = 0; mask < 8; mask++)
        for (int layers = 1; layers <= HALO; layers++) {
            struct fluid_grid *g = grid(mask & 1, mask >> 1 & 1, mask >> 2 & 1);
            double *a = calloc(g->size, sizeof *a), *b = calloc(g->size, sizeof *b), left = 0, right = 0, scale = 0,
                   ghosts = 0;
            for (int k = -layers; k < g->m[2] + layers; k++)
                for (int j = -layers; j < g->m[1] + layers; j++)
                    for (int i = -layers; i < g->m[0] + layers; i++) {
                        const size_t n = fluid_grid_at(g, i, j, k);
                        const int owned = i >= 0 && i < g->m[0] && j >= 0 && j < g->m[1] && k >= 0 && k < g->m[2];
                        if (owned) a[n] = random_at(i, j + g->lo[1], k + g->lo[2], 1);
                        b[n] = random_at(i, j, k, par_rank() + 2);
                    }
            double *copy = malloc(g->size * sizeof *copy);
            memcpy(copy, a, g->size * sizeof *copy);
            par_halo_fill(g->halos, 1, &copy, layers);
            for (size_t n = 0; n < g->size; n++) left += copy[n] * b[n];
            par_halo_add(g->halos, 1, &b, layers);
            for (size_t n = 0; n < g->size; n++) {
                right += a[n] * b[n];
                scale += fabs(a[n] * b[n]);
            }
            for (int k = -layers; k < g->m[2] + layers; k++)
                for (int j = -layers; j < g->m[1] + layers; j++)
                    for (int i = -layers; i < g->m[0] + layers; i++)
                        if (i < 0 || i >= g->m[0] || j < 0 || j >= g->m[1] || k < 0 || k >= g->m[2])
                            ghosts += fabs(b[fluid_grid_at(g, i, j, k)]);
            check_close(par_sum(left), par_sum(right), 1e-14 * par_sum(scale));
            check_equal(par_sum(ghosts), 0);
            free(a);
            free(b);
            free(copy);
            fluid_grid_free(g);
        }
}

/* Every cell has one owner, which rank_of finds, also for points outside a periodic direction. */
static void rank_of_finds_the_owner(void **state) {
    (void)state;
    struct fluid_grid *g = grid(1, 0, 1);
    for (int k = 0; k < NZ; k++)
        for (int j = 0; j < NY; j++) {
            const double x[3] = {-0.3, (j + 0.4) / NY, (k + 0.4) / NZ + 2};
            const int mine = j >= g->lo[1] && j < g->lo[1] + g->m[1] && k >= g->lo[2] && k < g->lo[2] + g->m[2];
            assert_int_equal(mine, fluid_grid_rank_of(g, x) == par_rank());
            assert_int_equal(par_sum_long(mine), 1);
        }
    assert_int_equal(fluid_grid_rank_of(g, (double[3]){0.5, 1.01, 0.5}), -1);
    assert_int_equal(fluid_grid_rank_of(g, (double[3]){0.5, -0.01, 0.5}), -1);
    check_at_least(fluid_grid_rank_of(g, (double[3]){0.5, 1.0, 0.5}), 0);
    fluid_grid_free(g);
}

FLUID_TEST_MAIN(cmocka_unit_test(fill_gives_images), cmocka_unit_test(add_is_adjoint),
                cmocka_unit_test(rank_of_finds_the_owner))
