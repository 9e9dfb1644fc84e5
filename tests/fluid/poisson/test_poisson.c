/* The direct Poisson solver against the discrete operator, for every pair of conditions in every direction. */
#include "fluid/poisson/poisson.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

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
                all[((size_t)(k + g->lo[2]) * (size_t)g->n[1] + (size_t)(j + g->lo[1])) * (size_t)g->n[0] + (size_t)i] =
                    mine[fluid_grid_at(g, i, j, k)];
    par_sum_array(all, (int)count);
}

struct planes {
    const struct fluid_grid *g;
    const double *b; /* [n_z][n_y][n_x] */
    double *q;
};

static void fill(void *data, int k, double *rhs) {
    const struct planes *planes = data;
    const struct fluid_grid *g = planes->g;
    for (int j = 0; j < g->m[1]; j++)
        for (int i = 0; i < g->n[0]; i++)
            rhs[j * g->n[0] + i] = planes->b[((k + g->lo[2]) * g->n[1] + j + g->lo[1]) * g->n[0] + i];
}

static double *place(void *data, int k) {
    const struct planes *planes = data;
    return planes->q + fluid_grid_at(planes->g, 0, 0, k);
}

struct error {
    double residual;     /* largest |lap q - b| over largest |b| */
    double mean;         /* if it is free: the mean minus the value asked for, over the largest |q| */
    double beyond;       /* largest error of the plane beyond the last, over the largest |q| */
    double section_mean; /* and of the predicted means over the first and last cells of each direction */
};

/* The means of the cells at both ends of each direction with free ends, as the solver predicts them. Collective. */
static void foresee(struct fluid_poisson *p, const int pair[3], double mean[3][2]) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2 && pair[d] == NN; side++)
            mean[d][side] = par_sum(fluid_poisson_section_mean(p, d, side));
}

static struct error solve(const int n[3], const int pair[3]) {
    const double length[3] = {1.0, 0.7, n[2] > 100 ? 0.1 * n[2] : 1.3}, wanted = 0.01;
    struct fluid_grid *g = fluid_grid_new(n, length, (int[3]){pair[0] == PP, pair[1] == PP, pair[2] == PP}, 1, NULL);
    struct fluid_poisson_input in = {.row = g->row};
    struct error error = {0, 0, 0, 0};
    int free_mean = 1;
    for (int d = 0; d < 3; d++) {
        in.n[d] = n[d];
        in.d[d] = g->d[d];
        in.ranks[d] = g->ranks[d];
        in.cut[d] = g->cut[d];
        memcpy(in.end[d], ends[pair[d]], sizeof in.end[d]);
        free_mean &= pair[d] == PP || pair[d] == NN;
    }
    struct fluid_poisson *p = fluid_poisson_new(&in);
    const size_t count = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    double *q = calloc(g->size, sizeof *q), *all = malloc(count * sizeof *all), *b = malloc(count * sizeof *b), sum = 0;
    for (size_t i = 0; i < count; i++) sum += b[i] = random_at((long)i, pair[0], pair[1], pair[2]);
    for (size_t i = 0; i < count && free_mean; i++) b[i] -= sum / (double)count;
    struct planes planes = {g, b, q};
    fluid_poisson_forward(p, fill, &planes);
    double foreseen[3][2] = {{0}}, section[3][2] = {{0}};
    if (free_mean) foresee(p, pair, foreseen);
    fluid_poisson_solve(p, wanted);
    fluid_poisson_backward(p, &(struct fluid_poisson_target){.place = place, .data = &planes});
    gather(g, q, all);
    double most = 0, largest = 0, mean = 0;
    const int stride[3] = {1, n[0], n[0] * n[1]};
    for (int c = 0; c < (int)count; c++) {
        const int at[3] = {c % n[0], c / n[0] % n[1], c / (n[0] * n[1])};
        double lap = 0;
        for (int d = 0; d < 3; d++) {
            const double *line = all + c - at[d] * stride[d];
            lap += (beyond(line, n[d], stride[d], at[d] - 1, in.end[d]) - 2 * all[c] +
                    beyond(line, n[d], stride[d], at[d] + 1, in.end[d])) /
                   (g->d[d] * g->d[d]);
        }
        error.residual = check_worst(error.residual, (lap - b[c]));
        most = fmax(most, fabs(b[c]));
        largest = fmax(largest, fabs(all[c]));
        mean += all[c] / (double)count;
        for (int d = 0; d < 3; d++)
            if (at[d] == 0 || at[d] == n[d] - 1) section[d][at[d] > 0] += all[c] * n[d] / ((double)n[0] * n[1] * n[2]);
    }
    for (int j = 0; j < g->m[1]; j++)
        for (int i = 0; i < n[0]; i++) {
            const double *line = all + (j + g->lo[1]) * n[0] + i;
            const double image = beyond(line, n[2], stride[2], g->lo[2] + g->m[2], in.end[2]);
            error.beyond = check_worst(error.beyond, q[fluid_grid_at(g, i, j, g->m[2])] - image);
        }
    error.residual /= most;
    error.beyond /= largest;
    if (free_mean) error.mean = fabs(mean - wanted) / largest;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2 && free_mean && pair[d] == NN; side++)
            error.section_mean =
                check_worst(error.section_mean, (section[d][side] - wanted - foreseen[d][side]) / largest);
    free(q);
    free(all);
    free(b);
    fluid_poisson_free(p);
    fluid_grid_free(g);
    return error;
}

static void check(const int n[3], const int pair[3]) {
    const struct error e = solve(n, pair);
    if (!(e.residual < 1e-12)) fail_msg("pairs %d %d %d: residual %g", pair[0], pair[1], pair[2], e.residual);
    if (!(e.mean < 1e-13)) fail_msg("pairs %d %d %d: mean %g", pair[0], pair[1], pair[2], e.mean);
    if (!(e.beyond < 1e-13)) fail_msg("pairs %d %d %d: beyond the last plane %g", pair[0], pair[1], pair[2], e.beyond);
    if (!(e.section_mean < 1e-13))
        fail_msg("pairs %d %d %d: section mean %g", pair[0], pair[1], pair[2], e.section_mean);
}

static void every_pair(const int n[3]) {
    for (int c = 0; c < PAIRS * PAIRS * PAIRS; c++) check(n, (int[3]){c % PAIRS, c / PAIRS % PAIRS, c / PAIRS / PAIRS});
}

static void odd(void **state) { (void)state, every_pair((int[3]){9, 11, 13}); }
static void thin(void **state) { (void)state, every_pair((int[3]){6, 5, 7}); }

/* Powers of two and larger grids use other paths of the transforms; in long columns powers of r vanish. */
static void larger(void **state) {
    (void)state;
    for (int c = 0; c < PAIRS; c++) {
        check((int[3]){32, 24, 16}, (int[3]){c, (c + 2) % PAIRS, c});
        check((int[3]){12, 8, 400}, (int[3]){(c + 1) % PAIRS, c, c});
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(odd), cmocka_unit_test(thin), cmocka_unit_test(larger))
