/* Connected porosity by a flood fill over all ranks. */
/* Each rank floods its own cells, exchanges its outer cells with its neighbours, and continues from the cells that the
 * flood has entered from there, until no rank has such a cell. */
#include "base/par.h"
#include "base/par_halo.h"
#include "coupling/medium/parts.h"

#include <string.h>

/* 1: the pore cells differ from those of the last flood. Sets the cells that differ. */
static int compare_cells(struct medium *m) {
    const struct fluid_grid *g = m->g;
    int differ = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double zy = m->weight[2][k] * m->weight[1][j];
            if (zy == 0) continue; /* walls always */
            differ |= medium_kernels_compare(g->m[0], zy, m->weight[0], m->fraction + fluid_grid_at(g, 0, j, k),
                                             m->cell + medium_rimmed(g, 0, j, k));
        }
    return differ;
}

/* The flood is to begin: no pore is reached. */
static void dry(struct medium *m) {
    const size_t rimmed = (size_t)(m->g->m[0] + 2) * (size_t)(m->g->m[1] + 2) * (size_t)(m->g->m[2] + 2);
    for (size_t at = 0; at < rimmed; at++) m->cell[at] = m->cell[at] == MEDIUM_WALL ? MEDIUM_WALL : MEDIUM_PORE;
}

/* Starts the flood in a section of the domain across the axis, from the cells that the level may enter. Returns the
 * number of this rank's; they are on the stack. */
static int start_at_section(struct medium *m, int section, uint8_t level) {
    const struct fluid_grid *g = m->g;
    int from[3] = {0, 0, 0}, to[3] = {g->m[0], g->m[1], g->m[2]}, n = 0;
    const int own = section - g->lo[m->axis];
    if (own < 0 || own >= g->m[m->axis]) return 0;
    from[m->axis] = own, to[m->axis] = own + 1;
    for (int k = from[2]; k < to[2]; k++)
        for (int j = from[1]; j < to[1]; j++)
            for (int i = from[0]; i < to[0]; i++) {
                const int at = medium_rimmed(g, i, j, k);
                if (m->cell[at] != level - 1) continue;
                m->cell[at] = level;
                m->stack[n++] = at;
            }
    return n;
}

/* One side of this rank's cells, across y (c = 1) or z (c = 2). give: copies the states of the outermost cells to
 * carry. take: the flood enters these cells from the ghosts beyond them. Returns the number of cells entered, added to
 * the stack's n. */
static int side_give_or_take(struct medium *m, int c, int high, int take, uint8_t level, int n) {
    const struct fluid_grid *g = m->g;
    const int other = 3 - c, last = g->m[c] - 1;
    const int own = high ? last : 0, ghost = high ? last + 1 : -1;
    for (int t = 0; t < g->m[other]; t++)
        for (int i = 0; i < g->m[0]; i++) {
            const int at = c == 1 ? medium_rimmed(g, i, own, t) : medium_rimmed(g, i, t, own);
            if (!take) {
                m->carry[c == 1 ? fluid_grid_at(g, i, own, t) : fluid_grid_at(g, i, t, own)] = m->cell[at];
            } else if (m->cell[at] == level - 1) {
                const double come = m->carry[c == 1 ? fluid_grid_at(g, i, ghost, t) : fluid_grid_at(g, i, t, ghost)];
                if (come != level) continue;
                m->cell[at] = level;
                m->stack[n++] = at;
            }
        }
    return n;
}

/* The flood passes from one end of x to the other, across the periodic side. */
static int over_x(struct medium *m, uint8_t level, int n) {
    const struct fluid_grid *g = m->g;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const int low = medium_rimmed(g, 0, j, k), high = medium_rimmed(g, g->m[0] - 1, j, k);
            const int to = m->cell[low] == level ? high : low, from = to == high ? low : high;
            if (m->cell[from] != level || m->cell[to] != level - 1) continue;
            m->cell[to] = level;
            m->stack[n++] = to;
        }
    return n;
}

void medium_connect_flood(struct medium *m, uint8_t level, int n, const int over[3]) {
    const struct fluid_grid *g = m->g;
    do {
        medium_kernels_flood(g->m, level, n, m->stack, m->cell);
        n = 0;
        for (int c = 1; c < 3; c++)
            for (int high = 0; high < 2; high++) side_give_or_take(m, c, high, 0, level, 0);
        par_halo_fill(g->halos, 1, &m->carry, 1);
        for (int c = 1; c < 3; c++)
            for (int high = 0; high < 2; high++)
                if (over[c] || !medium_at_end(g, c, high)) n = side_give_or_take(m, c, high, 1, level, n);
        if (over[0]) n = over_x(m, level, n);
    } while (par_sum_long(n) > 0);
}

double medium_connect_porosity(struct medium *m) {
    const struct fluid_grid *g = m->g;
    if (m->effective >= 0) return m->effective;
    int over[3];
    for (int c = 0; c < 3; c++) over[c] = g->periodic[c] && c != m->axis;
    if (par_sum_long(compare_cells(m)) > 0) { /* otherwise the last flood is still valid */
        dry(m);
        medium_connect_flood(m, MEDIUM_FRONT, start_at_section(m, m->first[m->axis], MEDIUM_FRONT), over);
        medium_connect_flood(m, MEDIUM_BOTH, start_at_section(m, m->last[m->axis], MEDIUM_BOTH), over);
    }

    double open = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double zy = m->weight[2][k] * m->weight[1][j];
            if (zy == 0) continue;
            open += zy * medium_kernels_open(g->m[0], m->weight[0], m->fraction + fluid_grid_at(g, 0, j, k),
                                             m->cell + medium_rimmed(g, 0, j, k));
        }
    return m->effective = par_sum(open) / m->total;
}
