/* Deposition, porosity and connected porosity against a serial brute-force computation. */
#include "base/memory.h"
#include "base/par.h"
#include "coupling/medium/medium.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { PARTICLES_MAX = 8192 };

/* The same sequence on every rank. */
static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

/* All particles, on every rank; each rank deposits some of them. */
static struct {
    int n;
    double x[3][PARTICLES_MAX], volume[PARTICLES_MAX];
} all;

static void particle_add(double x, double y, double z, double volume) {
    check_below(all.n, PARTICLES_MAX);
    all.x[0][all.n] = x, all.x[1][all.n] = y, all.x[2][all.n] = z;
    all.volume[all.n++] = volume;
}

static const double *lay_shared(struct medium *m, int spread) {
    static double mine[3][PARTICLES_MAX], volume[PARTICLES_MAX];
    int n = 0;
    for (int h = par_rank(); h < all.n; h += par_size(), n++) {
        for (int c = 0; c < 3; c++) mine[c][n] = all.x[c][h];
        volume[n] = all.volume[h];
    }
    const double *const x[3] = {mine[0], mine[1], mine[2]};
    if (spread) return medium_spread(m, n, x, volume);
    medium_deposit(m, n, x, volume);
    return medium_fraction(m);
}

static void deposit_shared(struct medium *m) { lay_shared(m, 0); }

static double overlap(double low, double high, double a, double b) { return fmax(0, fmin(high, b) - fmax(low, a)); }

/* The solid fraction of cell (i,j,k), by a sum over every particle and its periodic images. */
static double fraction_brute(const struct fluid_grid *g, int i, int j, int k) {
    const int at[3] = {i, j, k};
    double sum = 0;
    for (int h = 0; h < all.n; h++) {
        double part = 1;
        for (int c = 0; c < 3; c++) {
            const double half = 0.5 * cbrt(all.volume[h]), a = at[c] * g->d[c], b = (at[c] + 1) * g->d[c];
            double length = 0;
            for (int image = -2; image <= 2; image++)
                if (image == 0 || g->periodic[c]) {
                    const double x = all.x[c][h] + image * g->length[c];
                    length += overlap(x - half, x + half, a, b);
                }
            part *= length / g->d[c];
        }
        sum += part;
    }
    return sum;
}

static double fraction_sum(const struct fluid_grid *g, const struct medium *m) {
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) sum += medium_fraction(m)[fluid_grid_at(g, i, j, k)];
    return par_sum(sum);
}

static void random_particles(int n, const double L[3], double beyond, double side_low, double side_high) {
    all.n = 0;
    for (int h = 0; h < n; h++) {
        const double side = uniform(side_low, side_high);
        particle_add(uniform(-beyond, 1 + beyond) * L[0], uniform(-beyond, 1 + beyond) * L[1],
                     uniform(-beyond, 1 + beyond) * L[2], side * side * side);
    }
}

/* Periodic: no volume is lost, wherever the particles are; a second deposit with another distribution is correct as
 * well. */
static void test_volume_is_kept(void **state) {
    (void)state;
    const int n[3] = {13, 12, 15}, periodic[3] = {1, 1, 1};
    const double L[3] = {1.3, 1.2, 1.5}, low[3] = {0, 0, 0};
    struct fluid_grid *g = fluid_grid_new(n, L, periodic, 3, NULL);
    struct medium *m = medium_new(g, low, L);
    seed = 7;
    for (int time = 0; time < 3; time++) {
        random_particles(time == 1 ? 900 : 700, L, 1.2, 0.01, 0.19);
        deposit_shared(m);
        double volume = 0;
        for (int h = 0; h < all.n; h++) volume += all.volume[h];
        const double ours = fraction_sum(g, m) * g->d[0] * g->d[1] * g->d[2];
        check_close(ours, volume, 1e-13 * volume);
        check_close(medium_measure_porosity(m), 1 - volume / (1.3 * 1.2 * 1.5), 1e-13 * volume);
    }
    all.n = 0;
    deposit_shared(m);
    check_equal(fraction_sum(g, m), 0);
    medium_free(m);
    fluid_grid_free(g);
}

/* Spread by the forcing's kernel: no volume is lost, neither at closed sides; a lattice fills the cells within a plane
 * evenly, and none beyond the kernel, and its first moment stays where it is. */
static void test_spread(void **state) {
    (void)state;
    const int n[3] = {12, 13, 15}, periodic[3] = {0, 1, 1};
    const double L[3] = {1.2, 1.3, 1.5}, low[3] = {0, 0, 0};
    struct fluid_grid *g = fluid_grid_new(n, L, periodic, 3, NULL);
    struct medium *m = medium_new(g, low, L);
    seed = 3;
    random_particles(500, L, 0, 0.01, 0.29);
    double volume = 0;
    for (int h = 0; h < all.n; h++) volume += all.volume[h];
    const double *f = lay_shared(m, 1);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) sum += f[fluid_grid_at(g, i, j, k)];
    check_close(par_sum(sum) * g->d[0] * g->d[1] * g->d[2], volume, 1e-13 * volume);
    all.n = 0; /* solid below x = 0.55 */
    for (int k = 0; k < 15; k++)
        for (int j = 0; j < 13; j++)
            for (int i = 0; i < 11; i++)
                particle_add(0.05 * i + 0.025, 0.1 * j + 0.03, 0.1 * k + 0.07, 0.05 * 0.05 * 0.05);
    f = lay_shared(m, 1);
    double worst = 0;
    const double full = 0.25, plane[] = {0.45, 0.65}; /* two particles of an eighth in a cell */
    for (int i = 0; i < g->m[0]; i++) {
        const double here = f[fluid_grid_at(g, i, 0, 0)], x = (i + 0.5) * 0.1;
        if (x < 0.36) worst = check_worst(worst, here - full);
        if (x > 0.74) worst = check_worst(worst, here);
        if (fabs(x - 0.55) < 0.04) worst = check_worst(worst, here - 0.5 * full);
    }
    check_below(worst, 1e-13);
    const double beside[2] = {f[fluid_grid_at(g, (int)(plane[0] / 0.1), 0, 0)],
                              f[fluid_grid_at(g, (int)(plane[1] / 0.1), 0, 0)]};
    check_close(beside[0] + beside[1], full, 1e-13);
    check_between(beside[1], 0.01 * full, 0.2 * full);
    medium_free(m);
    fluid_grid_free(g);
}

/* Every cell and its nearest ghosts against brute force; x and z closed, and cubes up to five cells wide inside and
 * outside of the domain. */
static void test_every_cell(void **state) {
    (void)state;
    const int n[3] = {9, 12, 12}, periodic[3] = {0, 1, 0};
    const double L[3] = {0.9, 1.2, 1.2}, low[3] = {0, 0, 0};
    struct fluid_grid *g = fluid_grid_new(n, L, periodic, 3, NULL);
    struct medium *m = medium_new(g, low, L);
    seed = 11;
    for (int wide = 0; wide < 2; wide++) {
        random_particles(60, L, 0.2, 0.02, wide ? 0.5 : 0.15);
        deposit_shared(m);
        double worst = 0;
        for (int k = -1; k <= g->m[2]; k++)
            for (int j = -1; j <= g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int gj = (g->lo[1] + j + n[1]) % n[1], gk = g->lo[2] + k;
                    if (gk < 0 || gk >= n[2]) continue; /* beyond a closed side */
                    const double ours = medium_fraction(m)[fluid_grid_at(g, i, j, k)];
                    worst = check_worst(worst, ours - fraction_brute(g, i, gj, gk));
                }
        check_below(par_max(worst), 1e-13);
    }
    medium_free(m);
    fluid_grid_free(g);
}

/* A block with cavities, on the grid's lattice: cells are 0 or 1, and porosity is a count. The box's faces then cut
 * cells in half. */
static int solid_at(int i, int j, int k) {
    const double R = 4.6, P = 8; /* overlapping, as radius 9.2 to period 16 */
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double s = (c == 0 ? i - 4 : c == 1 ? j : k) + 0.5, away = s - P * round(s / P);
        r2 += away * away;
    }
    return i >= 4 && i < 20 && r2 > R * R;
}

static void test_cavity_lattice(void **state) {
    (void)state;
    const int n[3] = {24, 16, 16}, periodic[3] = {0, 0, 1};
    const double d = 0.0015625, L[3] = {24 * d, 16 * d, 16 * d};
    const double low[3] = {4 * d, 0, 0}, high[3] = {20 * d, 16 * d, 16 * d};
    struct fluid_grid *g = fluid_grid_new(n, L, periodic, 1, NULL);
    struct medium *m = medium_new(g, low, high);
    all.n = 0;
    for (int k = 0; k < 16; k++)
        for (int j = -3; j < 16; j++) /* with three layers outside the domain, as a held block has */
            for (int i = 4; i < 20; i++)
                if (solid_at(i, j, k)) particle_add((i + 0.5) * d, (j + 0.5) * d, (k + 0.5) * d, d * d * d);
    deposit_shared(m);

    long inside = 0, narrow = 0;
    double worst = 0;
    for (int k = 0; k < 16; k++)
        for (int j = 0; j < 16; j++)
            for (int i = 0; i < 24; i++) {
                if (solid_at(i, j, k)) inside++;
                if (i >= 6 && i < 10 && solid_at(i, j, k)) narrow += i == 6 ? 1 : 2; /* half of cell 6 */
                const int lj = j - g->lo[1], lk = k - g->lo[2];
                if (lj < 0 || lj >= g->m[1] || lk < 0 || lk >= g->m[2]) continue;
                worst = check_worst(worst, medium_fraction(m)[fluid_grid_at(g, i, lj, lk)] - solid_at(i, j, k));
            }
    check_below(par_max(worst), 1e-12);
    check_close(medium_measure_porosity(m), 1 - (double)inside / 4096, 1e-13);
    check_close(medium_connect_porosity(m), medium_measure_porosity(m), 1e-12); /* every cavity is open */
    medium_free(m);

    const double cut_low[3] = {6.5 * d, 0, 0}, cut_high[3] = {10 * d, 16 * d, 16 * d};
    m = medium_new(g, cut_low, cut_high);
    deposit_shared(m);
    check_close(medium_measure_porosity(m), 1 - 0.5 * (double)narrow / (3.5 * 256), 1e-13);
    medium_free(m);
    fluid_grid_free(g);
}

/* Solid where map says so, on 12^3 cells of width 1. */
enum { M = 12 };
static uint8_t map[M][M][M]; /* [k][j][i] 1: solid */

static void deposit_map(struct medium *m) {
    all.n = 0;
    for (int k = 0; k < M; k++)
        for (int j = 0; j < M; j++)
            for (int i = 0; i < M; i++)
                if (map[k][j][i]) particle_add(i + 0.5, j + 0.5, k + 0.5, 1);
    deposit_shared(m);
}

static struct fluid_grid *map_grid(int periodic_y, int periodic_z) {
    const int n[3] = {M, M, M}, periodic[3] = {0, periodic_y, periodic_z};
    const double L[3] = {M, M, M};
    return fluid_grid_new(n, L, periodic, 1, NULL);
}

static struct medium *map_medium(struct fluid_grid *g) {
    const double low[3] = {0, 0, 0}, high[3] = {M, M, M};
    return medium_new(g, low, high);
}

static void assert_effective(struct medium *m, double cells) {
    const double ours = medium_connect_porosity(m) * M * M * M;
    if (fabs(ours - cells) > 1e-9) print_error("connected cells: %.12g, expected %.12g\n", ours, cells);
    check_close(ours, cells, 1e-9);
}

/* A straight pore, a dead end from either face, and a closed cavity: only the first counts. */
static void test_closed_does_not_count(void **state) {
    (void)state;
    struct fluid_grid *g = map_grid(0, 0);
    struct medium *m = map_medium(g);
    memset(map, 1, sizeof map);
    for (int i = 0; i < M; i++) map[2][2][i] = 0;
    for (int i = 0; i < 8; i++) map[8][3][i] = map[4][9][M - 1 - i] = 0;
    for (int k = 5; k < 8; k++)
        for (int j = 5; j < 8; j++) map[k][j][5] = map[k][j][6] = 0;
    deposit_map(m);
    assert_effective(m, M);
    check_close(medium_measure_porosity(m) * M * M * M, M + 16 + 18, 1e-9);
    map[2][2][6] = 1; /* blocked */
    deposit_map(m);
    assert_effective(m, 0);
    medium_free(m);
    fluid_grid_free(g);
}

/* One pore, one cell wide, that runs up and down all of z and y and through every rank. */
static void test_winding_path(void **state) {
    (void)state;
    struct fluid_grid *g = map_grid(0, 0);
    struct medium *m = map_medium(g);
    memset(map, 1, sizeof map);
    int cells = 0;
    for (int i = 0; i < M; i += 2) { /* a comb in the plane x = i, up z, over in y, down z, ... */
        for (int j = 0; j < M - 1; j += 2) {
            for (int k = 0; k < M; k++) map[k][j][i] = 0, cells++;
            if (j + 2 < M - 1) map[(j / 2) % 2 ? 0 : M - 1][j + 1][i] = 0, cells++;
        }
        /* the comb has six teeth: it enters and leaves at z = 0, on opposite ends of y in turn */
        map[0][(i / 2) % 2 ? 0 : 10][i + 1] = 0, cells++;
    }
    deposit_map(m);
    assert_effective(m, cells);
    map[6][4][6] = 1; /* a blocked cell half way: the ends are no longer connected */
    deposit_map(m);
    assert_effective(m, 0);
    medium_free(m);
    fluid_grid_free(g);
}

/* Connection across periodic sides in y and z, and only where they are periodic. */
static void test_path_across_periodic_sides(void **state) {
    (void)state;
    memset(map, 1, sizeof map);
    for (int i = 0; i < 5; i++) map[0][3][i] = 0;
    map[M - 1][3][4] = 0; /* from z = 0 to its other side */
    for (int j = 0; j <= 3; j++) map[M - 1][j][4] = 0;
    for (int i = 4; i < M; i++) map[M - 1][M - 1][i] = 0; /* from y = 0 to its other side */
    for (int both = 0; both < 2; both++) {
        struct fluid_grid *g = map_grid(1, both);
        struct medium *m = map_medium(g);
        deposit_map(m);
        assert_effective(m, both ? 5 + 4 + 8 : 0);
        medium_free(m);
        fluid_grid_free(g);
    }
}

/* Random media about the percolation threshold (0.31), against repeated sweeps over the whole map. */
static double effective_brute(int periodic_y, int periodic_z) {
    static uint8_t reached[2][M][M][M];
    memset(reached, 0, sizeof reached);
    for (int face = 0; face < 2; face++)
        for (int changed = 1; changed;) {
            changed = 0;
            for (int k = 0; k < M; k++)
                for (int j = 0; j < M; j++)
                    for (int i = 0; i < M; i++) {
                        if (map[k][j][i] || reached[face][k][j][i]) continue;
                        int joined = i == (face ? M - 1 : 0);
                        for (int b = -1; b <= 1; b += 2) {
                            if (i + b >= 0 && i + b < M) joined |= reached[face][k][j][i + b];
                            if (periodic_y || (j + b >= 0 && j + b < M)) joined |= reached[face][k][(j + b + M) % M][i];
                            if (periodic_z || (k + b >= 0 && k + b < M)) joined |= reached[face][(k + b + M) % M][j][i];
                        }
                        if (joined) reached[face][k][j][i] = 1, changed = 1;
                    }
        }
    double cells = 0;
    for (int k = 0; k < M; k++)
        for (int j = 0; j < M; j++)
            for (int i = 0; i < M; i++) cells += reached[0][k][j][i] && reached[1][k][j][i];
    return cells;
}

static void test_random_media(void **state) {
    (void)state;
    seed = 3;
    const int x_high[3][2] = {{0, 1}, {0, 0}, {0, 0}};
    double most = 0, least = 1e9;
    for (int sample = 0; sample < 12; sample++) {
        const int py = sample % 2, pz = sample / 2 % 2;
        struct fluid_grid *g = map_grid(py, pz);
        struct medium *m = map_medium(g);
        for (int k = 0; k < M; k++)
            for (int j = 0; j < M; j++)
                for (int i = 0; i < M; i++) map[k][j][i] = uniform(0, 1) > 0.28 + 0.02 * (sample / 2);
        deposit_map(m);
        const double cells = effective_brute(py, pz);
        assert_effective(m, cells);
        assert_int_equal(medium_cut_off(m, 0, 0, x_high, 1) < 1, cells > 0);
        assert_effective(m, cells); /* as before */
        most = fmax(most, cells), least = fmin(least, cells);
        medium_free(m);
        fluid_grid_free(g);
    }
    check_equal(least, 0);
    check_above(most, 200); /* the samples lie on both sides of the threshold */
}

/* Two channels from y_low: one turns, crosses the periodic sides of x and reaches y_high; one is closed. */
static void test_cut_off(void **state) {
    (void)state;
    const int n[3] = {M, M, M}, y_high[3][2] = {{0, 0}, {0, 1}, {0, 0}}, y_low[3][2] = {{0, 0}, {1, 0}, {0, 0}};
    const double L[3] = {M, M, M};
    memset(map, 1, sizeof map);
    for (int j = 0; j < M; j++) map[5][j][j < 6 ? 0 : M - 1] = map[8][j][3] = 0;
    map[5][6][0] = 0;
    map[8][7][3] = 1;
    for (int wraps = 0; wraps < 2; wraps++) {
        const int periodic[3] = {wraps, 0, 0}, along_y[3] = {1, 1, 0};
        struct fluid_grid *g = fluid_grid_new(n, L, periodic, 1, NULL);
        struct medium *m = map_medium(g);
        deposit_map(m);
        const double cells = M * M, through = wraps ? 1 : 0;
        check_close(medium_cut_off(m, 1, 0, y_high, 1), 1 - through / cells, 1e-12);
        check_close(medium_cut_off(m, 1, 1, y_low, 1), 1 - through / cells, 1e-12);
        check_close(medium_cut_off(m, 1, 0, y_low, 1), 1 - 2 / cells, 1e-12);
        medium_free(m);
        fluid_grid_free(g);
        g = fluid_grid_new(n, L, along_y, 1, NULL); /* y periodic: from end to end, or across as well */
        m = map_medium(g);
        deposit_map(m);
        check_close(medium_cut_off(m, 1, 0, y_high, 0), 1 - 1 / cells, 1e-12);
        check_close(medium_cut_off(m, 1, 0, y_high, 1), 1 - 2 / cells, 1e-12);
        medium_free(m);
        fluid_grid_free(g);
    }
}

/* A cell counts as pore up to half full, and then with its void part. */
static void test_half_full_cells(void **state) {
    (void)state;
    struct fluid_grid *g = map_grid(0, 0);
    struct medium *m = map_medium(g);
    memset(map, 1, sizeof map);
    for (int i = 0; i < M; i++) map[6][6][i] = 0;
    deposit_map(m);
    particle_add(3.5, 6.5, 6.5, 0.4);
    deposit_shared(m);
    assert_effective(m, M - 0.4);
    particle_add(3.5, 6.5, 6.5, 0.2);
    deposit_shared(m);
    assert_effective(m, 0);
    check_close(medium_measure_porosity(m) * M * M * M, M - 0.6, 1e-9);
    medium_free(m);
    fluid_grid_free(g);
}

/* All memory is freed. */
static void test_memory(void **state) {
    (void)state;
    const size_t before = memory_bytes(MEMORY_COUPLING);
    struct fluid_grid *g = map_grid(0, 0);
    struct medium *m = map_medium(g);
    deposit_map(m);
    check_above(memory_bytes(MEMORY_COUPLING), before);
    medium_free(m);
    check_equal(memory_bytes(MEMORY_COUPLING), before);
    fluid_grid_free(g);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_volume_is_kept),
        cmocka_unit_test(test_spread),
        cmocka_unit_test(test_every_cell),
        cmocka_unit_test(test_cavity_lattice),
        cmocka_unit_test(test_closed_does_not_count),
        cmocka_unit_test(test_winding_path),
        cmocka_unit_test(test_path_across_periodic_sides),
        cmocka_unit_test(test_random_media),
        cmocka_unit_test(test_half_full_cells),
        cmocka_unit_test(test_memory),
        cmocka_unit_test(test_cut_off),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
