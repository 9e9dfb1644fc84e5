/* Finds the open faces, and the walls beside them. */
#include "stokes/faces.h"
#include "base/memory.h"
#include "base/par.h"

#include <string.h>

/* What is across a face: what its velocity's neighbour is. */
enum neighbour { SLIP, OPEN, EDGE, WALL, NEIGHBOURS };
enum { PAIRS = NEIGHBOURS * (NEIGHBOURS + 1) / 2 };

static enum neighbour neighbour_of(const struct stokes_grid *g, const int at[3], int c, int direction) {
    const struct stokes_mask *m = g->mask;
    int low[3] = {at[0], at[1], at[2]}, wraps;
    const enum stokes_beyond beyond = stokes_grid_step(g, low, direction, &wraps);
    if (beyond != STOKES_BEYOND_NONE) return beyond == STOKES_BEYOND_SLIP ? SLIP : WALL;
    int high[3] = {low[0], low[1], low[2]};
    if (direction / 2 == g->axis && stokes_grid_is_outside(g, low)) return SLIP;
    stokes_grid_step(g, high, 2 * c + 1, &wraps);
    switch (stokes_mask_is(m, low[0], low[1], low[2]) + stokes_mask_is(m, high[0], high[1], high[2])) {
    case 0:
        return WALL;
    case 1:
        return EDGE;
    default:
        return OPEN;
    }
}

/* The number of an unordered pair. */
static int pair_of(enum neighbour a, enum neighbour b) { return a > b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a; }

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
    int pair[2];
    if (!is_open(g, at, c)) return STOKES_FACES_CLOSED;
    for (int t = 1; t < 3; t++) {
        const int low = 2 * ((c + t) % 3);
        pair[t - 1] = pair_of(neighbour_of(g, at, c, low), neighbour_of(g, at, c, low + 1));
    }
    return pair[0] + PAIRS * pair[1] + (inner_of(g, at, c) >= 0 ? STOKES_FACES_KINDS / 2 : 0);
}

/* What two neighbours add to the diagonal, in units of 1/d^2. */
static void set_weights(double weight[PAIRS], int smooth) {
    const double neighbour_weight[NEIGHBOURS] = {[OPEN] = 1, [EDGE] = smooth ? 1 : STOKES_FACES_EDGE, [WALL] = 2};
    for (int a = 0; a < NEIGHBOURS; a++)
        for (int b = 0; b <= a; b++) weight[pair_of(a, b)] = neighbour_weight[a] + neighbour_weight[b];
}

static void set_diagonals(struct stokes_faces *f, const double d[3], int smooth) {
    double weight[PAIRS];
    set_weights(weight, smooth);
    for (int c = 0; c < 3; c++)
        for (int kind = 0; kind < STOKES_FACES_KINDS; kind++) {
            const int pairs = kind % (STOKES_FACES_KINDS / 2), half = kind != pairs;
            const double dt = d[(c + 1) % 3], ds = d[(c + 2) % 3];
            const double across = weight[pairs % PAIRS] / (dt * dt) + weight[pairs / PAIRS] / (ds * ds);
            f->diagonal[c][kind] = half ? 0.5 * across + 1 / (d[c] * d[c]) : across + 2 / (d[c] * d[c]);
            f->single[c][kind] = (float)f->diagonal[c][kind];
            f->inverse[c][kind] = (float)(1 / f->diagonal[c][kind]);
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
    set_diagonals(f, g->in.d, g->in.smooth);
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
    MEMORY_FREE(f->kind, f->half, f);
}
