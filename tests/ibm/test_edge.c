/* Markers whose blocks reach over a side or another rank's cells: what they read and what they write, without a
 * ghost. */
#include "base/par.h"
#include "ibm/state.h"
#include "tests/check.h"
#include "tests/ibm/scattered.h"

#include <stdlib.h>

static const double low_velocity[2] = {0.5, -1}, high_velocity[2] = {2, 0.25}; /* x, y */

/* walls: 1: across y, at rest; 2: across z, which move. */
static struct fluid *box(int walls) {
    struct fluid_input in = {
        .n = {12, 12, 14}, .length = {0.6, 0.6, 0.7}, .density = 1, .viscosity = 0.01, .immersed = 1};
    for (int side = 0; side < 2; side++) {
        if (walls & 1) in.side[1][side].type = FLUID_WALL;
        if (walls & 2) in.side[2][side].type = FLUID_WALL;
        for (int d = 0; d < 2 && walls & 2; d++)
            in.side[2][side].velocity[d] = side ? high_velocity[d] : low_velocity[d];
    }
    return fluid_new(&in);
}

/* Three arrays of the grid: NaN, but in this rank's cells and on the domain's low sides, where they are `value` of
 * the place. */
static void fill(const struct fluid_grid *g, double (*value)(int c, const double x[3]), double *u[3]) {
    for (int c = 0; c < 3; c++) {
        u[c] = malloc(g->size * sizeof(double));
        for (size_t n = 0; n < g->size; n++) u[c][n] = NAN;
        int low[3];
        for (int d = 0; d < 3; d++) low[d] = d == c && !g->periodic[d] && g->lo[d] == 0 ? -1 : 0;
        for (int k = low[2]; k < g->m[2]; k++)
            for (int j = low[1]; j < g->m[1]; j++)
                for (int i = low[0]; i < g->m[0]; i++) {
                    const int at[3] = {i, j, k};
                    double x[3];
                    for (int d = 0; d < 3; d++) x[d] = (g->lo[d] + at[d] + (d == c ? 1 : 0.5)) * g->d[d];
                    u[c][fluid_grid_at(g, i, j, k)] = value(c, x);
                }
    }
}

/* A shear flow between walls z = 0 and 0.7 that move: as the kernel keeps linear fields, and the walls' conditions
 * continue this one. */
static double shear(int c, const double x[3]) {
    return c == 2 ? 0 : low_velocity[c] + (high_velocity[c] - low_velocity[c]) * x[2] / 0.7;
}
static double zero(int c, const double x[3]) { return 0 * (c + x[0]); }

static const double *item_of(const struct ibm *b, int h) { return b->route.served + (size_t)b->arrival[h] * IBM_ITEM; }

/* What a marker in the first cell beside a wall reads from beyond it lies a cell too far inside, since it is folded
 * back.
 */
static double folded(const struct fluid_grid *g, int c, double z) {
    const double place[2][3] = {{0, 0, 0}, {0, 0, g->d[2]}}, rise = shear(c, place[1]) - shear(c, place[0]);
    const int cell = (int)fmin(floor(z), g->n[2] - 1);
    double w[3];
    ibm_kernel_weights(z - cell - 0.5, w);
    return cell == 0 ? w[0] * rise : cell == g->n[2] - 1 ? -w[2] * rise : 0;
}

static void linear_flow_between_walls(void **state) {
    (void)state;
    struct fluid *f = box(2);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = ibm_new(f, 1);
    double x[3][SCATTERED], volume[SCATTERED], *u[3], (*velocity)[3] = malloc((SCATTERED + 1) * sizeof *velocity);
    const int n = scattered(g, x, volume);
    const double *const at[3] = {x[0], x[1], x[2]};
    ibm_markers_set(b, n, at, at, volume);
    fill(g, shear, u);
    ibm_transfer_read(b, u, 1, velocity);
    check_above(b->edges, 0);
    for (int h = 0; h < b->served; h++)
        for (int c = 0; c < 3; c++) {
            const double z = item_of(b, h)[2], place[3] = {0, 0, z * g->d[2]};
            check_close(velocity[h][c], shear(c, place) + (c < 2 ? folded(g, c, z) : 0), 1e-13);
        }
    free(velocity);
    for (int c = 0; c < 3; c++) free(u[c]);
    ibm_free(b);
    fluid_free(f);
}

/* What strengths of 1 leave on the grid adds up to the shares of the markers that are counted here: all of it away
 * from walls and along them (x), and across them (y, z) less than all. */
static void what_is_written_is_shared(void **state) {
    (void)state;
    for (int walls = 0; walls < 4; walls += 3) {
        struct fluid *f = box(walls);
        const struct fluid_grid *g = fluid_grid_of(f);
        struct ibm *b = ibm_new(f, 1);
        double x[3][SCATTERED], volume[SCATTERED], *u[3], sum[3] = {0}, shares[3] = {0},
                                                          (*strength)[3] = malloc((SCATTERED + 1) * sizeof *strength);
        const int n = scattered(g, x, volume);
        const double *const at[3] = {x[0], x[1], x[2]};
        ibm_markers_set(b, n, at, at, volume);
        fill(g, zero, u);
        for (int h = 0; h < b->served; h++) {
            const struct ibm_edge *e = h < b->inner ? NULL : &b->edge[h - b->inner];
            for (int c = 0; c < 3; c++) {
                strength[h][c] = 1;
                if (!e || e->mine) shares[c] += e ? e->share[c] : 1;
                if (e && !walls) check_close(e->share[c], 1, 1e-14);
                if (e) check_between(e->share[c], -1e-14, 1 + 1e-14);
            }
        }
        ibm_transfer_write(b, u, (const double(*)[3])strength);
        for (int c = 0; c < 3; c++)
            for (int k = -1; k < g->m[2]; k++)
                for (int j = -1; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const double value = u[c][fluid_grid_at(g, i, j, k)];
                        const int cell[3] = {i, j, k}, high = g->lo[c] + cell[c] + 1 == g->n[c];
                        if (j >= 0 && k >= 0) sum[c] += value;
                        const int on_side = !g->periodic[c] && (high || cell[c] < 0);
                        if (on_side && isfinite(value)) check_equal(value, 0); /* takes nothing */
                    }
        par_sum_array(sum, 3);
        par_sum_array(shares, 3);
        for (int c = 0; c < 3; c++) {
            check_relative(sum[c], shares[c], 1e-13);
            if (!walls || c == 0) check_relative(sum[c], SCATTERED, 1e-13);
            if (walls && c > 0) check_between(sum[c], 0.8 * SCATTERED, 0.99 * SCATTERED);
        }
        free(strength);
        for (int c = 0; c < 3; c++) free(u[c]);
        ibm_free(b);
        fluid_free(f);
    }
}

static const double uniform_velocity[3] = {0.7, -0.3, 1.1};
/* Within the box; on its walls across y and z, which hold the normal velocity, 1e3. */
static double uniform(int c, const double x[3]) {
    const double length[3] = {0.6, 0.6, 0.7};
    const int is_on_wall = c > 0 && (x[c] < 1e-9 || x[c] > length[c] - 1e-9);
    return is_on_wall ? 1e3 : uniform_velocity[c];
}

/* Where the fluid within moves with the markers nothing is demanded of it, however near the walls are, although these
 * are at rest; and each marker's fraction is what is spread of its force. */
static void walls_demand_nothing_of_fluid_that_moves_with_the_body(void **state) {
    (void)state;
    struct fluid *f = box(3);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = ibm_new(f, 1);
    double x[3][SCATTERED], volume[SCATTERED], *u[3], most = 0, (*read)[3] = calloc(SCATTERED + 1, sizeof *read);
    const int n = scattered(g, x, volume);
    const double *const at[3] = {x[0], x[1], x[2]};
    ibm_markers_set(b, n, at, at, volume);
    fill(g, uniform, u);
    ibm_transfer_sample(b, u, read);
    for (int h = 0; h < n; h++)
        for (int c = 0; c < 3; c++) {
            const double fraction = ibm_markers_fraction(b, c, x[c][h]);
            check_close(read[h][c], fraction * uniform_velocity[c], 1e-13);
            most = fmax(most, 1 - fraction);
            if (c == 0) check_equal(fraction, 1);
        }
    check_above(par_max(most), 0.6);
    for (int h = 0; h < b->served; h++)
        for (int c = 0; c < 3; c++) {
            const double share = h < b->inner ? 1 : b->edge[h - b->inner].share[c];
            check_close(share, ibm_markers_fraction(b, c, item_of(b, h)[c] * g->d[c]), 1e-13);
        }
    free(read);
    for (int c = 0; c < 3; c++) free(u[c]);
    ibm_free(b);
    fluid_free(f);
}

static double wavy(int c, const double x[3]) { return sin(7 * x[0] + c) + cos(9 * x[1] - c) * x[2]; }

/* Values at the markers, spread with their volumes, are the adjoint of the reading: <S q, u> = sum V q.(J u); and the
 * sum that is returned is what the grid has got. Most values are 0. */
static void spreading_by_volume_is_adjoint_to_reading(void **state) {
    (void)state;
    for (int walls = 0; walls < 4; walls += 3) {
        struct fluid *f = box(walls);
        const struct fluid_grid *g = fluid_grid_of(f);
        struct ibm *b = ibm_new(f, 1);
        double x[3][SCATTERED], volume[SCATTERED], *u[3], *spread[3], got[3], whole[3], product[2] = {0}, all[9] = {0};
        double(*value)[3] = calloc(SCATTERED + 1, sizeof *value), (*read)[3] = calloc(SCATTERED + 1, sizeof *read);
        const int n = scattered(g, x, volume);
        const double *const at[3] = {x[0], x[1], x[2]}, cell = g->d[0] * g->d[1] * g->d[2];
        ibm_markers_set(b, n, at, at, volume);
        fill(g, wavy, u);
        fill(g, zero, spread);
        for (int h = 0; h < n; h += h % 9 == 4 ? 30 : 1)
            for (int c = 0; c < 3; c++) value[h][c] = cos(h + 2 * c);
        ibm_transfer_sample(b, u, read);
        ibm_transfer_spread(b, 0, spread, (const double(*)[3])value, got, whole);
        for (int h = 0; h < n; h++)
            for (int c = 0; c < 3; c++) {
                product[0] += volume[h] / cell * value[h][c] * read[h][c];
                all[6 + c] += volume[h] / cell * value[h][c];
            }
        for (int c = 0; c < 3; c++) {
            all[c] = got[c];
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const size_t q = fluid_grid_at(g, i, j, k);
                        product[1] += spread[c][q] * u[c][q];
                        all[3 + c] += spread[c][q];
                    }
        }
        par_sum_array(product, 2);
        par_sum_array(all, 9);
        par_sum_array(whole, 3);
        check_relative(product[1], product[0], 1e-12);
        for (int c = 0; c < 3; c++) {
            check_above(fabs(all[c]), 1e-3);
            check_relative(all[3 + c], all[c], 1e-11);
            check_relative(whole[c], all[6 + c], 1e-11);
        }
        free(value);
        free(read);
        for (int c = 0; c < 3; c++) free(u[c]), free(spread[c]);
        ibm_free(b);
        fluid_free(f);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(linear_flow_between_walls),
                                       cmocka_unit_test(what_is_written_is_shared),
                                       cmocka_unit_test(walls_demand_nothing_of_fluid_that_moves_with_the_body),
                                       cmocka_unit_test(spreading_by_volume_is_adjoint_to_reading)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
