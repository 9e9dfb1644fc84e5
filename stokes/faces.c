/* Finds the open faces, and the walls beside them. */
#include "stokes/faces.h"
#include "base/memory.h"
#include "base/par.h"

#include <string.h>

/* What a neighbour across c adds to the diagonal, in units of 1/d^2: 1 for a mirrored wall, -1 without shear. */
static int beside(const struct stokes_grid *g, const int at[3], int c, int direction) {
    const struct stokes_mask *m = g->mask;
    int low[3] = {at[0], at[1], at[2]}, wraps;
    const enum stokes_beyond beyond = stokes_grid_step(g, low, direction, &wraps);
    if (beyond != STOKES_BEYOND_NONE) return beyond == STOKES_BEYOND_SLIP ? -1 : 1;
    int high[3] = {low[0], low[1], low[2]};
    if (direction / 2 == g->axis && stokes_grid_is_outside(g, low)) return -1;
    stokes_grid_step(g, high, 2 * c + 1, &wraps);
    return !stokes_mask_is(m, low[0], low[1], low[2]) && !stokes_mask_is(m, high[0], high[1], high[2]);
}

static int is_open(const struct stokes_grid *g, const int at[3], int c) {
    int high[3] = {at[0], at[1], at[2]}, wraps;
    if (stokes_grid_step(g, high, 2 * c + 1, &wraps) != STOKES_BEYOND_NONE) return 0;
    if (stokes_grid_is_outside(g, at) && (c != g->axis || stokes_grid_is_outside(g, high))) return 0;
    return stokes_mask_is(g->mask, high[0], high[1], high[2]);
}

/* Whether an open face is on a side of given pressure, and the direction of the fluid: 0 or 1; -1: it is not. */
static int inner_of(const struct stokes_grid *g, const int at[3], int c) {
    if (c != g->axis) return -1;
    return at[c] == 0 ? 1 : at[c] == g->mask->n[c] - 2 ? 0 : -1;
}

static int kind_of(const struct stokes_grid *g, const int at[3], int c) {
    int sum[2] = {2, 2};
    if (!is_open(g, at, c)) return STOKES_FACES_CLOSED;
    for (int t = 1; t < 3; t++)
        for (int high = 0; high < 2; high++) sum[t - 1] += beside(g, at, c, 2 * ((c + t) % 3) + high);
    return sum[0] + 5 * sum[1] + (inner_of(g, at, c) >= 0 ? STOKES_FACES_KINDS / 2 : 0);
}

static void set_diagonals(struct stokes_faces *f, const double d[3]) {
    for (int c = 0; c < 3; c++)
        for (int kind = 0; kind < STOKES_FACES_KINDS; kind++) {
            const int of = kind % (STOKES_FACES_KINDS / 2), half = kind != of;
            const double dt = d[(c + 1) % 3], ds = d[(c + 2) % 3];
            const double across = of % 5 / (dt * dt) + of / 5 / (ds * ds);
            f->diagonal[c][kind] = half ? 0.5 * across + 1 / (d[c] * d[c]) : across + 2 / (d[c] * d[c]);
        }
}

static void add_half(struct stokes_faces *f, int cell, int inner) {
    const size_t n = (size_t)f->halves;
    if ((n & (n - 1)) == 0) f->half = memory_grown(MEMORY_FLUID, f->half, n, 2 * n + 1, sizeof *f->half);
    f->half[f->halves++] = (struct stokes_faces_half){cell, inner};
}

struct stokes_faces *stokes_faces_new(const struct stokes_cells *cells) {
    const struct stokes_grid *g = cells->g;
    struct stokes_faces *f = memory_new(MEMORY_FLUID, 1, sizeof *f);
    int at[3];
    f->kind = memory_new(MEMORY_FLUID, stokes_cells_size(cells), sizeof *f->kind);
    memset(f->kind, STOKES_FACES_CLOSED, stokes_cells_size(cells) * sizeof *f->kind);
    set_diagonals(f, g->in.d);
    if (cells->n > 0) stokes_mask_find(g->mask, cells->first[par_rank()], at);
    for (int i = 0; i < cells->n; i++) {
        if (i > 0) stokes_mask_next(g->mask, at);
        for (int c = 0; c < 3; c++) {
            f->kind[i][c] = (uint8_t)kind_of(g, at, c);
            f->open[c] += stokes_faces_is_open(f, i, c);
            const int inner = stokes_faces_is_open(f, i, c) ? inner_of(g, at, c) : -1;
            if (inner >= 0) add_half(f, i, 2 * c + inner);
        }
    }
    par_sum_long_array(f->open, 3);
    stokes_cells_fill(cells, sizeof *f->kind, f->kind);
    return f;
}

void stokes_faces_free(struct stokes_faces *f) {
    if (!f) return;
    memory_free(f->kind);
    memory_free(f->half);
    memory_free(f);
}
