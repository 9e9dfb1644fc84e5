/* Divides the cells over the ranks by the work of a coupled step. */
#include "coupling/setup/share.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/setup/setup.h"
#include "fluid/grid/grid.h"
#include "solid/surface/surface.h"

#include <math.h>
#include <stdlib.h>

/* What markers cost more than cells: forcing and probe of a marker take as long as this many cells of the fluid's step
 * (docs/performance.md: 6.1 ms for 22,100 markers where 524,288 cells take 8.9 ms). */
static const double MARKER_CELLS = 16;

double *share_work(const struct fluid_grid *g, const struct solid *s, const struct solid_surface *surface) {
    const int rows = g->n[1] * g->n[2];
    double *work = memory_new(MEMORY_COUPLING, (size_t)rows + 1, sizeof *work);
    for (int i = 0; i < surface->n; i++) {
        const int h = surface->h[i];
        int at[3], is_inside = 1;
        for (int d = 0; d < 3; d++) {
            at[d] = (int)floor((s->x0[d][h] + s->d[d][h]) / g->d[d]);
            if (g->periodic[d]) at[d] = ((at[d] % g->n[d]) + g->n[d]) % g->n[d];
            is_inside &= at[d] >= 0 && at[d] < g->n[d];
        }
        if (is_inside) work[at[2] * g->n[1] + at[1]] += MARKER_CELLS;
    }
    par_sum_array(work, rows);
    for (int i = 0; i < rows; i++) work[i] += g->n[0];
    return work;
}

/* Sums over the other direction: weight[1] [n_y], weight[2] [n_z]. */
static void weigh(const int n[3], const double *work, double *const weight[3]) {
    for (int d = 1; d < 3; d++)
        for (int i = 0; i < n[d]; i++) weight[d][i] = 0;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++) {
            weight[1][j] += work[k * n[1] + j];
            weight[2][k] += work[k * n[1] + j];
        }
}

void share_cut(const int n[3], int halo, const double *work, const int ranks[3], int *const cut[3]) {
    double *weight[3] = {NULL, calloc((size_t)n[1], sizeof(double)), calloc((size_t)n[2], sizeof(double))};
    if (work) weigh(n, work, weight);
    for (int d = 1; d < 3; d++) {
        fluid_grid_cut(n[d], work ? weight[d] : NULL, ranks[d], halo, cut[d]);
        free(weight[d]);
    }
}

double share_imbalance(const int n[3], const double *work, const int ranks[3], const int *const cut[3]) {
    double most = 0, sum = 0;
    for (int a = 0; a < ranks[2]; a++)
        for (int b = 0; b < ranks[1]; b++) {
            double piece = 0;
            for (int k = cut[2][a]; k < cut[2][a + 1]; k++)
                for (int j = cut[1][b]; j < cut[1][b + 1]; j++) piece += work[k * n[1] + j];
            most = fmax(most, piece);
            sum += piece;
        }
    return most * ranks[1] * ranks[2] / sum;
}

struct fluid *share_divide(const struct scene *scene, struct fluid *fluid, const struct solid *s,
                           const struct solid_surface *surface) {
    const struct fluid_grid *g = fluid_grid_of(fluid);
    if (par_size() == 1) return fluid;
    double *work = share_work(g, s, surface);
    int *cut[3] = {NULL, NULL, NULL};
    for (int d = 1; d < 3; d++) cut[d] = calloc((size_t)g->ranks[d] + 1, sizeof *cut[d]);
    share_cut(g->n, g->halo, work, g->ranks, cut);
    const double by_work = share_imbalance(g->n, work, g->ranks, (const int *const *)cut),
                 as_is = share_imbalance(g->n, work, g->ranks, (const int *const *)g->cut);
    if (by_work < 0.97 * as_is) {
        struct fluid_input in;
        double *weight[3] = {NULL, calloc((size_t)g->n[1], sizeof(double)), calloc((size_t)g->n[2], sizeof(double))};
        weigh(g->n, work, weight);
        setup_fluid(scene, &in);
        for (int d = 1; d < 3; d++) in.weight[d] = weight[d];
        fluid_free(fluid);
        fluid = fluid_new(&in);
        for (int d = 1; d < 3; d++) free(weight[d]);
    }
    for (int d = 1; d < 3; d++) free(cut[d]);
    memory_free(work);
    return fluid;
}
