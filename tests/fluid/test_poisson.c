/* The direct Poisson solver against the discrete operator, for every pair of conditions in every direction. */
#include "fluid_case.h"
#include "fluid/poisson.h"

#include <stdlib.h>

enum { PP, DD, NN, DN, ND, PAIRS };
static const enum fluid_end ends[PAIRS][2] = {{FLUID_END_PERIODIC, FLUID_END_PERIODIC},
                                              {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET},
                                              {FLUID_END_NEUMANN, FLUID_END_NEUMANN},
                                              {FLUID_END_DIRICHLET, FLUID_END_NEUMANN},
                                              {FLUID_END_NEUMANN, FLUID_END_DIRICHLET}};

/* The value beyond an end is the image of the value at it: the other end's, minus or plus itself. */
static double beyond(const double *line, int n, int stride, int i, const enum fluid_end end[2]) {
    if (i >= 0 && i < n) return line[i * stride];
    const enum fluid_end e = end[i < 0 ? 0 : 1];
    const int inside = e == FLUID_END_PERIODIC ? (i + n) % n : i < 0 ? 0 : n - 1;
    return e == FLUID_END_DIRICHLET ? -line[inside * stride] : line[inside * stride];
}

/* The solution gathered on every rank, [nz][ny][nx]. */
static void gather(const struct fluid_grid *g, const double *mine, double *all) {
    const size_t count = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2];
    memset(all, 0, count * sizeof *all);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                all[((size_t)(k + g->lo[2]) * (size_t)g->n[1] + (size_t)(j + g->lo[1])) * (size_t)g->n[0] +
                    (size_t)i] = mine[fluid_grid_at(g, i, j, k)];
    par_sum_array(all, (int)count);
}

/* Largest |lap q - b| over largest |b|; and the mean of q over its largest value where nothing fixes it. */
static void solve(const int n[3], const int pair[3], enum fluid_poisson_last last, double *residual,
                  double *mean) {
    const double length[3] = {1.0, 0.7, 1.3};
    struct fluid_grid *g =
        fluid_grid_new(n, length, (int[3]){pair[0] == PP, pair[1] == PP, pair[2] == PP}, 1);
    struct fluid_poisson_input in = {.last = last, .row = g->row, .plane = g->plane};
    int free_mean = 1;
    for (int d = 0; d < 3; d++) {
        in.n[d] = n[d];
        in.d[d] = g->d[d];
        in.ranks[d] = g->ranks[d];
        memcpy(in.end[d], ends[pair[d]], sizeof in.end[d]);
        free_mean &= pair[d] == PP || pair[d] == NN;
    }
    struct fluid_poisson *p = fluid_poisson_new(&in);
    const size_t count = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    double *q = calloc(g->size, sizeof *q), *all = malloc(count * sizeof *all),
           *b = malloc(count * sizeof *b), sum = 0;
    for (size_t i = 0; i < count; i++) sum += b[i] = random_at((long)i, pair[0], pair[1], pair[2]);
    for (size_t i = 0; i < count && free_mean; i++) b[i] -= sum / (double)count;
    for (int k = 0; k < g->m[2]; k++) {
        double *plane = fluid_poisson_plane(p, k);
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < n[0]; i++)
                plane[j * n[0] + i] = b[((k + g->lo[2]) * n[1] + j + g->lo[1]) * n[0] + i];
        fluid_poisson_plane_forward(p, k);
    }
    fluid_poisson_solve(p, q + fluid_grid_at(g, 0, 0, 0));
    gather(g, q, all);
    double most = 0, largest = 0;
    const int stride[3] = {1, n[0], n[0] * n[1]};
    *residual = *mean = 0;
    for (int c = 0; c < (int)count; c++) {
        const int at[3] = {c % n[0], c / n[0] % n[1], c / (n[0] * n[1])};
        double lap = 0;
        for (int d = 0; d < 3; d++) {
            const double *line = all + c - at[d] * stride[d];
            lap += (beyond(line, n[d], stride[d], at[d] - 1, in.end[d]) - 2 * all[c] +
                    beyond(line, n[d], stride[d], at[d] + 1, in.end[d])) /
                   (g->d[d] * g->d[d]);
        }
        *residual = worse(*residual, (lap - b[c]));
        most = fmax(most, fabs(b[c]));
        largest = fmax(largest, fabs(all[c]));
        if (free_mean) *mean += all[c] / (double)count;
    }
    *residual /= most;
    *mean = fabs(*mean) / largest;
    free(q);
    free(all);
    free(b);
    fluid_poisson_free(p);
    fluid_grid_free(g);
}

static void every_pair(const int n[3], enum fluid_poisson_last last) {
    for (int c = 0; c < PAIRS * PAIRS * PAIRS; c++) {
        const int pair[3] = {c % PAIRS, c / PAIRS % PAIRS, c / PAIRS / PAIRS};
        double residual, mean;
        if (last == FLUID_POISSON_TRIDIAGONAL && pair[2] == PP) continue;
        solve(n, pair, last, &residual, &mean);
        if (!(residual < 1e-12)) fail_msg("pairs %d %d %d: residual %g", pair[0], pair[1], pair[2], residual);
        if (!(mean < 1e-13)) fail_msg("pairs %d %d %d: mean %g", pair[0], pair[1], pair[2], mean);
    }
}

static void odd_by_transform(void **state) {
    (void)state, every_pair((int[3]){9, 11, 13}, FLUID_POISSON_TRANSFORM);
}
static void odd_by_bands(void **state) {
    (void)state, every_pair((int[3]){9, 11, 13}, FLUID_POISSON_TRIDIAGONAL);
}
static void thin_by_transform(void **state) {
    (void)state, every_pair((int[3]){6, 5, 7}, FLUID_POISSON_TRANSFORM);
}
static void thin_by_bands(void **state) {
    (void)state, every_pair((int[3]){6, 5, 7}, FLUID_POISSON_TRIDIAGONAL);
}

/* Powers of two and larger grids take other paths through the transforms. */
static void larger(void **state) {
    (void)state;
    for (int c = 0; c < PAIRS; c++)
        for (int last = FLUID_POISSON_TRANSFORM; last <= FLUID_POISSON_TRIDIAGONAL; last++) {
            double residual, mean;
            if (c == PP && last == FLUID_POISSON_TRIDIAGONAL) continue;
            solve((int[3]){32, 24, 16}, (int[3]){c, (c + 2) % PAIRS, c}, (enum fluid_poisson_last)last,
                  &residual, &mean);
            assert_below(residual, 1e-12);
        }
}

FLUID_TEST_MAIN(cmocka_unit_test(odd_by_transform), cmocka_unit_test(odd_by_bands),
                cmocka_unit_test(thin_by_transform), cmocka_unit_test(thin_by_bands),
                cmocka_unit_test(larger))
