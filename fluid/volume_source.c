/* Volume that enters or leaves the flow at points: div u = q in their cells. */
#include "base/memory.h"
#include "base/par_exchange.h"
#include "base/par_piece.h"
#include "fluid/internal.h"

#include <math.h>
#include <string.h>

struct fluid_volume_source {
    double *rate; /* [m2][m1][m0] of each cell, 1/s */
    struct par_exchange *plan;
};

enum { PLACE, RATE = PLACE + 3, ITEM }; /* of a point: its cell, its rate */

/* The cell of a point; 0: beside the domain, or next to a side, where the low faces follow from div u = 0. */
static int cell_of(const struct fluid_grid *g, const double x[3], int cell[3]) {
    for (int c = 0; c < 3; c++) {
        double at = floor(x[c] / g->d[c]);
        if (g->periodic[c]) at -= g->n[c] * floor(at / g->n[c]);
        const int beside = !g->periodic[c];
        if (!(at >= beside && at < g->n[c] - beside)) return 0;
        cell[c] = (int)at;
    }
    return 1;
}

int fluid_volume_source_holds(const struct fluid *f, const double x[3]) {
    int cell[3];
    return cell_of(f->grid, x, cell);
}

void fluid_volume_source_clear(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    if (f->source) memset(f->source->rate, 0, sizeof(double) * (size_t)g->m[0] * (size_t)g->m[1] * (size_t)g->m[2]);
}

void fluid_volume_source_set(struct fluid *f, int n, const double (*x)[3], const double *rate) {
    const struct fluid_grid *g = f->grid;
    const double volume = g->d[0] * g->d[1] * g->d[2];
    if (!f->source) {
        f->source = memory_new(MEMORY_FLUID, 1, sizeof *f->source);
        f->source->rate = memory_new(MEMORY_FLUID, (size_t)g->m[0] * (size_t)g->m[1] * (size_t)g->m[2], sizeof(double));
    }
    fluid_volume_source_clear(f);
    double(*local)[ITEM] = memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof *local);
    int *dest = memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof *dest);
    for (int i = 0; i < n; i++) {
        int cell[3];
        dest[i] = -1;
        if (!cell_of(g, x[i], cell)) continue;
        dest[i] =
            par_piece_of(g->cut[1], g->ranks[1], cell[1]) + par_piece_of(g->cut[2], g->ranks[2], cell[2]) * g->ranks[1];
        for (int c = 0; c < 3; c++) local[i][PLACE + c] = cell[c];
        local[i][RATE] = rate[i];
    }
    f->source->plan = par_exchange_renew(f->source->plan, n, NULL, dest);
    const int served = par_exchange_count(f->source->plan);
    double(*item)[ITEM] = memory_new(MEMORY_FLUID, (size_t)served + 1, sizeof *item);
    par_exchange_forward(f->source->plan, local, item, sizeof *item);
    for (int i = 0; i < served; i++) {
        size_t at = 0;
        for (int c = 2; c >= 0; c--) at = at * (size_t)g->m[c] + (size_t)((int)item[i][PLACE + c] - g->lo[c]);
        f->source->rate[at] += item[i][RATE] / volume;
    }
    MEMORY_FREE(local, dest, item);
}

void fluid_volume_source_subtract(const struct fluid *f, int k, double factor, double *plane) {
    const size_t cells = (size_t)f->grid->m[0] * (size_t)f->grid->m[1];
    const double *rate = f->source->rate + (size_t)k * cells;
    for (size_t i = 0; i < cells; i++) plane[i] -= factor * rate[i];
}

void fluid_volume_source_free(struct fluid_volume_source *s) {
    if (!s) return;
    memory_free(s->rate);
    par_exchange_free(s->plan);
    memory_free(s);
}
