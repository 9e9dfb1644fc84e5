/* Cells that no path through pore cells joins to an outlet: their part of a side. */
#include "base/par.h"
#include "coupling/medium/parts.h"

#include <math.h>
#include <string.h>

/* Sets all cells of the domain; those of the rim stay walls. */
static void set_cells(struct medium *m) {
    const struct fluid_grid *g = m->g;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                m->cell[medium_rimmed(g, i, j, k)] =
                    medium_kernels_is_pore(m->fraction[fluid_grid_at(g, i, j, k)]) ? MEDIUM_PORE : MEDIUM_WALL;
}

/* This rank's cells along a side, and the number of them that the flood has reached. start: the flood enters the pores
 * among them, which are put on the stack after n. */
struct along {
    int cells, reached;
};
static struct along along_side(struct medium *m, int d, int high, int start, int n) {
    const struct fluid_grid *g = m->g;
    int from[3] = {0, 0, 0}, to[3] = {g->m[0], g->m[1], g->m[2]};
    struct along sum = {0};
    if (!medium_at_end(g, d, high)) return sum;
    if (high)
        from[d] = g->m[d] - 1;
    else
        to[d] = 1;
    for (int k = from[2]; k < to[2]; k++)
        for (int j = from[1]; j < to[1]; j++)
            for (int i = from[0]; i < to[0]; i++) {
                const int at = medium_rimmed(g, i, j, k);
                sum.cells++;
                if (m->cell[at] != (start ? MEDIUM_PORE : MEDIUM_FRONT)) continue;
                if (start) m->cell[at] = MEDIUM_FRONT, m->stack[n + sum.reached] = at;
                sum.reached++;
            }
    return sum;
}

void medium_cut_off_flood(struct medium *m, const int outlets[3][2], const int over[3]) {
    int n = 0;
    set_cells(m);
    for (int c = 0; c < 3; c++)
        for (int side = 0; side < 2; side++)
            if (outlets[c][side]) n += along_side(m, c, side, 1, n).reached;
    medium_connect_flood(m, MEDIUM_FRONT, n, over);
}

double medium_cut_off(struct medium *m, int d, int high, const int outlets[3][2], int across) {
    const struct fluid_grid *g = m->g;
    int over[3];
    for (int c = 0; c < 3; c++) over[c] = g->periodic[c] && (c != d || across);
    medium_cut_off_flood(m, outlets, over);
    const struct along side = along_side(m, d, high, 0, 0);
    const long cells = par_sum_long(side.cells), reached = par_sum_long(side.reached);
    memset(m->cell, MEDIUM_WALL, (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2));
    m->effective = -1;
    return 1 - (double)reached / (double)cells;
}
