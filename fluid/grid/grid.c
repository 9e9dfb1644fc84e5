/* Divides the cells over the ranks and lays out the arrays of the staggered grid. */
#include "fluid/grid/grid.h"
#include "base/die.h"
#include "base/par.h"
#include "base/par_halo.h"
#include "base/par_piece.h"
#include "fluid/internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Whether every rank of the grid gets at least `thick` cells in y and z, and its share of x in a y pencil. */
static int admits(const int n[3], int parts_y, int parts_z, int thick) {
    return n[1] / parts_y >= (parts_y > 1 ? thick : 1) && n[2] / parts_z >= (parts_z > 1 ? thick : 1) &&
           n[0] >= parts_y;
}

/* Slabs in z if they are `thick` enough, else the pair of divisors with the least surface between ranks; 0: none. */
static int choose(const int n[3], int size, int thick, int ranks[3]) {
    double least = INFINITY;
    for (int y = 1; y <= size; y++) {
        if (size % y || !admits(n, y, size / y, thick)) continue;
        const double surface = (y - 1.0) * n[2] + (size / y - 1.0) * n[1];
        if (surface < least) {
            least = surface;
            memcpy(ranks, (int[3]){1, y, size / y}, 3 * sizeof *ranks);
        }
        if (y == 1) break;
    }
    return isfinite(least);
}

int fluid_grid_choose(const int n[3], int size, int halo, int ranks[3]) {
    return choose(n, size, 2 * halo > 4 ? 2 * halo : 4, ranks) || choose(n, size, halo, ranks);
}

static void choose_or_die(const int n[3], int halo, int ranks[3]) {
    const int size = par_size();
    if (fluid_grid_choose(n, size, halo, ranks)) return;
    int most = size - 1;
    while (most > 1 && !choose(n, most, halo, ranks)) most--;
    die_all(EXIT_CODE_SCENE,
            "domain.cells = [%d, %d, %d]: cannot be divided over %d ranks, each of which needs %d cells or "
            "more in y and z; "
            "the largest number of ranks up to that is %d",
            n[0], n[1], n[2], size, halo, most);
}

static ptrdiff_t rounded_up(ptrdiff_t cells) {
    return (cells + FLUID_GRID_LANES - 1) / FLUID_GRID_LANES * FLUID_GRID_LANES;
}

static void lay_out(struct fluid_grid *g) {
    const ptrdiff_t h = g->halo;
    g->row = rounded_up(g->m[0]) + rounded_up(2 * h);
    g->plane = g->row * (g->m[1] + 2 * h);
    g->first = h * g->plane + h * g->row + rounded_up(h);
    g->size = (size_t)(g->plane * (g->m[2] + 2 * h) + rounded_up(h));
}

void fluid_grid_cut(int n, const double *weight, int pieces, int halo, int *first) {
    const int even = n / pieces, third = even / 3 > halo ? even / 3 : halo;
    par_piece_cut(n, pieces > 1 ? weight : NULL, pieces, third < even ? third : even, first);
}

/* Pieces along d, of which this rank has the c-th. */
static void cut(struct fluid_grid *g, int d, int c, const double *weight) {
    g->cut[d] = calloc((size_t)g->ranks[d] + 1, sizeof *g->cut[d]);
    fluid_grid_cut(g->n[d], weight, g->ranks[d], g->halo, g->cut[d]);
    g->lo[d] = g->cut[d][c];
    g->m[d] = g->cut[d][c + 1] - g->lo[d];
}

struct fluid_grid *fluid_grid_new(const int n[3], const double length[3], const int periodic[3], int halo,
                                  const double *const weight[3]) {
    for (int d = 0; d < 3; d++)
        if (n[d] < 1 || (periodic[d] && n[d] < halo))
            die_all(EXIT_CODE_SCENE, "domain.cells = [%d, %d, %d]: each periodic direction needs at least %d cell%s",
                    n[0], n[1], n[2], halo,
                    halo > 1 ? "s: a flow in a plane beside a solid takes a slice of 4 or more" : "");
    struct fluid_grid *g = calloc(1, sizeof *g);
    choose_or_die(n, halo, g->ranks);
    const int c[3] = {0, par_rank() % g->ranks[1], par_rank() / g->ranks[1]};
    g->halo = halo;
    for (int d = 0; d < 3; d++) {
        g->n[d] = n[d];
        g->length[d] = length[d];
        g->d[d] = length[d] / n[d];
        g->periodic[d] = periodic[d];
        cut(g, d, c[d], weight ? weight[d] : NULL);
    }
    lay_out(g);
    struct par_halo_input in = {.halo = halo, .first = g->first, .row = g->row, .plane = g->plane};
    memcpy(in.m, g->m, sizeof in.m);
    memcpy(in.ranks, g->ranks, sizeof in.ranks);
    memcpy(in.periodic, g->periodic, sizeof in.periodic);
    g->halos = par_halo_new(&in);
    return g;
}

const struct fluid_grid *fluid_grid_of(const struct fluid *f) { return f->grid; }

void fluid_grid_free(struct fluid_grid *g) {
    if (!g) return;
    par_halo_free(g->halos);
    for (int d = 0; d < 3; d++) free(g->cut[d]);
    free(g);
}

size_t fluid_grid_cells(const struct fluid_grid *g) { return (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2]; }

int fluid_grid_rank_of(const struct fluid_grid *g, const double x[3]) {
    int cell[3];
    for (int d = 0; d < 3; d++) {
        double at = x[d] / g->d[d];
        if (g->periodic[d])
            at -= g->n[d] * floor(at / g->n[d]);
        else if (!(at >= 0) || at > g->n[d])
            return -1;
        cell[d] = (int)at;
        if (cell[d] >= g->n[d]) cell[d] = g->n[d] - 1; /* the far end of the domain belongs to the last cell */
    }
    return par_piece_of(g->cut[2], g->ranks[2], cell[2]) * g->ranks[1] + par_piece_of(g->cut[1], g->ranks[1], cell[1]);
}
