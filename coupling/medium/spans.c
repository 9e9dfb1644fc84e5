/* Whether the solid is connected from the front of the box to its back. */
#include "base/par.h"
#include "coupling/medium/parts.h"

#include <string.h>

static int is_solid(const struct medium *m, int i, int j, int k) {
    return !medium_kernels_is_pore(m->fraction[fluid_grid_at(m->g, i, j, k)]);
}

/* The solid within the box is what the flood may enter. Its cells in the first section across direction d are put on
 * the stack; returns their number. */
static int begin(struct medium *m, int d) {
    const struct fluid_grid *g = m->g;
    int n = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const int at = medium_rimmed(g, i, j, k), own[3] = {i, j, k};
                const double weight = m->weight[0][i] * m->weight[1][j] * m->weight[2][k];
                const int solid = weight > 0 && is_solid(m, i, j, k), start = solid && g->lo[d] + own[d] == m->first[d];
                m->cell[at] = !solid ? MEDIUM_WALL : start ? MEDIUM_FRONT : MEDIUM_PORE;
                if (start) m->stack[n++] = at;
            }
    return n;
}

enum medium_span medium_spans(struct medium *m, int d) {
    const struct fluid_grid *g = m->g;
    int over[3], from[3] = {0, 0, 0}, to[3] = {g->m[0], g->m[1], g->m[2]};
    double reached[2] = {0}; /* cells of the last section; those of them that have solid beyond the periodic side */
    for (int c = 0; c < 3; c++) over[c] = g->periodic[c] && c != d;
    medium_connect_flood(m, MEDIUM_FRONT, begin(m, d), over);
    from[d] = m->last[d] - g->lo[d], to[d] = from[d] + 1;
    if (from[d] >= 0 && from[d] < g->m[d])
        for (int k = from[2]; k < to[2]; k++)
            for (int j = from[1]; j < to[1]; j++)
                for (int i = from[0]; i < to[0]; i++) {
                    if (m->cell[medium_rimmed(g, i, j, k)] != MEDIUM_FRONT) continue;
                    reached[0]++;
                    if (m->whole_period[d]) reached[1] += is_solid(m, i + (d == 0), j + (d == 1), k + (d == 2));
                }
    memset(m->cell, MEDIUM_WALL, (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2));
    m->effective = -1;
    par_sum_array(reached, 2);
    return reached[1] > 0 ? MEDIUM_SPAN_ENDLESS : reached[0] > 0 ? MEDIUM_SPAN_BOX : MEDIUM_SPAN_NONE;
}
