/* Whether the solid goes on through a periodic side. */
#include "base/par.h"
#include "coupling/medium/parts.h"

#include <string.h>

static int is_solid(const struct medium *m, int i, int j, int k) {
    return m->fraction[fluid_grid_at(m->g, i, j, k)] >= 0.5;
}

/* The solid is what the flood may enter. The cells along the low side of direction d are put on the stack; returns
 * their number. */
static int begin(struct medium *m, int d) {
    const struct fluid_grid *g = m->g;
    int n = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const int at = medium_rimmed(g, i, j, k), own[3] = {i, j, k};
                const int solid = is_solid(m, i, j, k), start = solid && g->lo[d] + own[d] == 0;
                m->cell[at] = !solid ? MEDIUM_WALL : start ? MEDIUM_FRONT : MEDIUM_PORE;
                if (start) m->stack[n++] = at;
            }
    return n;
}

int medium_spans(struct medium *m, int d) {
    const struct fluid_grid *g = m->g;
    int over[3];
    long spans = 0;
    if (!g->periodic[d]) return 0;
    for (int c = 0; c < 3; c++) over[c] = g->periodic[c] && c != d;
    medium_connect_flood(m, MEDIUM_FRONT, begin(m, d), over);
    int from[3] = {0, 0, 0};
    if (medium_at_end(g, d, 1)) {
        from[d] = g->m[d] - 1;
        for (int k = from[2]; k < g->m[2]; k++)
            for (int j = from[1]; j < g->m[1]; j++)
                for (int i = from[0]; i < g->m[0]; i++)
                    spans += m->cell[medium_rimmed(g, i, j, k)] == MEDIUM_FRONT &&
                             is_solid(m, i + (d == 0), j + (d == 1), k + (d == 2));
    }
    memset(m->cell, MEDIUM_WALL, (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2));
    m->effective = -1;
    return par_sum_long(spans) > 0;
}
