/* Momentum stage against its formula written out face by face, for every memory layout of the kernel. */
/* In separate arrays and in place; on a plane of one block of rows and of several; with rows of whole and of partial
 * eights; with arrays small and large enough for streaming stores. */
#include "base/memory.h"
#include "fluid/momentum/momentum.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <stdlib.h>

struct fields {
    double *q[3], *p, *predicted[3], *rate[3];
};

static double *random_array(const struct fluid_grid *g, int which) {
    double *a = memory_new(MEMORY_FLUID, g->size, sizeof *a);
    for (size_t n = 0; n < g->size; n++) a[n] = random_at((long)n, which, 7, 11);
    return a;
}

static struct fields new_fields(const struct fluid_grid *g, int in_place) {
    struct fields f = {.p = random_array(g, 3)};
    for (int c = 0; c < 3; c++) {
        f.q[c] = random_array(g, c);
        f.rate[c] = random_array(g, 4 + c);
        f.predicted[c] = in_place ? f.q[c] : random_array(g, 7 + c);
    }
    return f;
}

static void free_fields(struct fields *f) {
    for (int c = 0; c < 3; c++) {
        if (f->predicted[c] != f->q[c]) memory_free(f->predicted[c]);
        memory_free(f->q[c]);
        memory_free(f->rate[c]);
    }
    memory_free(f->p);
}

/* The flux along d of component c through the face after n: the product of the mean velocities. */
static double through(const double *const q[3], const ptrdiff_t stride[3], int c, int d, ptrdiff_t n) {
    return 0.25 * (q[d][n] + q[d][n + stride[c]]) * (q[c][n] + q[c][n + stride[d]]);
}

static double rate_at(const struct fluid_momentum_stage *s, const double *const q[3], int c, ptrdiff_t n) {
    const struct fluid_grid *g = s->grid;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    double rate = 0;
    for (int d = 0; d < 3; d++) {
        const ptrdiff_t e = stride[d];
        rate += s->viscosity * (q[c][n + e] - 2 * q[c][n] + q[c][n - e]) / (g->d[d] * g->d[d]);
        rate -= (through(q, stride, c, d, n) - through(q, stride, c, d, n - e)) / g->d[d];
    }
    return rate;
}

/* Whether the face of component c in cell i is advanced. */
static int is_advanced(const struct fluid_momentum_stage *s, int c, const int at[3]) { return at[c] < s->faces[c]; }

static void compare(const struct fluid_momentum_stage *s, const struct fields *before, const struct fields *after,
                    int in_place) {
    const struct fluid_grid *g = s->grid;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const double *const q[3] = {before->q[0], before->q[1], before->q[2]};
    double worst = 0, worst_rate = 0, untouched = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, i, j, k);
                    const double old = before->rate[c][n], now = rate_at(s, q, c, n);
                    if (!is_advanced(s, c, (int[3]){i, j, k})) {
                        untouched = check_worst(untouched, after->rate[c][n] - old);
                        if (c > 0)
                            untouched = check_worst(untouched, after->predicted[c][n] -
                                                                   (in_place ? q[c][n] : before->predicted[c][n]));
                        continue;
                    }
                    const double gradient = (before->p[n + stride[c]] - before->p[n]) / g->d[c];
                    const double next =
                        q[c][n] + s->a * now + s->b * old + s->c * (s->source[c] - s->inverse_density * gradient);
                    worst = check_worst(worst, after->predicted[c][n] - next);
                    worst_rate = check_worst(worst_rate, after->rate[c][n] - (s->store_rate ? now : old));
                }
    /* sums of some twenty terms, none above 10 */
    check_close(worst, 0, 1e-13);
    check_close(worst_rate, 0, 1e-13);
    check_close(untouched, 0, 0);
}

static void stage_is_its_formula(void **state) {
    (void)state;
    const int cells[3][3] = {{20, 9, 8}, {512, 36, 10}, {1000, 16, 28}};
    const int periodic[3] = {1, 1, 1};
    for (int size = 0; size < 3; size++)
        for (int kind = 0; kind < 12; kind++) {
            const int in_place = kind % 2, sides = kind / 2 % 2, r = kind / 4;
            if (size && check_skips(kind + kind / 2 + size, 2)) continue;
            struct fluid_grid *g = fluid_grid_new(
                cells[size], (double[3]){0.9 * cells[size][0], 1.1 * cells[size][1], 1.0 * cells[size][2]}, periodic, 1,
                NULL);
            struct fields before = new_fields(g, 0), after = new_fields(g, in_place);
            struct fluid_momentum_stage s = {.grid = g,
                                             .faces = {g->m[0] - sides, g->m[1] - sides, g->m[2] - sides},
                                             .a = 0.7,
                                             .b = r == 0 ? 0 : -0.3,
                                             .c = 0.4,
                                             .store_rate = r < 2,
                                             .viscosity = 0.3,
                                             .inverse_density = 0.8,
                                             .source = {0.1, -0.2, 0.3}};
            s.work = memory_new_work(MEMORY_FLUID, fluid_momentum_work(g));
            const double *const q[3] = {after.q[0], after.q[1], after.q[2]};
            fluid_momentum_predict(&s, q, after.p, after.predicted, after.rate);
            compare(&s, &before, &after, in_place);
            memory_free(s.work);
            free_fields(&before);
            free_fields(&after);
            fluid_grid_free(g);
        }
}

FLUID_TEST_MAIN(cmocka_unit_test(stage_is_its_formula))
