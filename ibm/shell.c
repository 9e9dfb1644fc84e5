/* Forces of markers whose blocks reach over a side of this rank's piece are gathered in arrays of their own, summed
 * across ranks and periodic sides, and only then added: the rest goes straight into the velocity. Only rows near the
 * sides are ever touched. */
#include "base/par_halo.h"
#include "ibm/state.h"

#include <string.h>

enum {
    REACH = 4
}; /* such a marker's three blocks span cells -2 .. 2 from the low side, m-4 .. m+1 at the high one */

static int near_side(const struct fluid_grid *g, int direction, int i) {
    return i < REACH || i >= g->m[direction] - REACH;
}

/* Ranges of x of a row in which the shell may be non-zero: at most two. */
static int row_ranges(const struct ibm *b, int j, int k, int ghosts, int range[2][2]) {
    const struct fluid_grid *g = b->grid;
    const int first = ghosts ? -g->halo : 0, last = ghosts ? g->m[0] + g->halo : g->m[0];
    if (near_side(g, 1, j) || near_side(g, 2, k)) {
        range[0][0] = b->crossing_x || b->x_low < first ? first : b->x_low;
        range[0][1] = b->crossing_x || b->x_high > last ? last : b->x_high;
        return 1;
    }
    if (!b->crossing_x) return 0;
    range[0][0] = first, range[0][1] = REACH < g->m[0] ? REACH : g->m[0];
    range[1][0] = g->m[0] - REACH > range[0][1] ? g->m[0] - REACH : range[0][1], range[1][1] = last;
    return 2;
}

void ibm_shell_clear(struct ibm *b) {
    const struct fluid_grid *g = b->grid;
    int range[2][2];
    for (int k = -g->halo; k < g->m[2] + g->halo; k++)
        for (int j = -g->halo; j < g->m[1] + g->halo; j++) {
            const int ranges = row_ranges(b, j, k, 1, range);
            for (int r = 0; r < ranges; r++)
                for (int c = 0; c < 3 && range[r][1] > range[r][0]; c++)
                    memset(b->shell[c] + fluid_grid_at(g, range[r][0], j, k), 0,
                           (size_t)(range[r][1] - range[r][0]) * sizeof(double));
        }
}

void ibm_shell_add(struct ibm *b, double *const u[3]) {
    const struct fluid_grid *g = b->grid;
    par_halo_add(g->halos, 3, b->shell, 2);
    int range[2][2];
    for (int c = 0; c < 3; c++) {
        /* faces on the domain's sides take no force */
        int m[3];
        for (int d = 0; d < 3; d++)
            m[d] = g->m[d] - (d == c && !g->periodic[d] && g->lo[d] + g->m[d] == g->n[d]);
        for (int k = 0; k < m[2]; k++)
            for (int j = 0; j < m[1]; j++) {
                const int ranges = row_ranges(b, j, k, 0, range);
                for (int r = 0; r < ranges; r++) {
                    const int high = range[r][1] < m[0] ? range[r][1] : m[0];
                    double *to = u[c] + fluid_grid_at(g, 0, j, k);
                    const double *from = b->shell[c] + fluid_grid_at(g, 0, j, k);
                    for (int i = range[r][0]; i < high; i++) to[i] += from[i];
                }
            }
    }
}
