/* Walks along a monotone piece of an edge from lattice cell to lattice cell. */
#include "solid/geometry/outline_edge.h"

#include <math.h>

struct solid_outline_walk solid_outline_walk_begin(const struct solid_outline_edge *piece, const int low[2],
                                                   const int high[2]) {
    struct solid_outline_walk w = {.piece = piece};
    for (int c = 0; c < 2; c++) {
        w.step[c] = (piece->b[c] > piece->a[c]) - (piece->b[c] < piece->a[c]);
        const double cell = w.step[c] < 0 ? ceil(piece->a[c]) - 1 : floor(piece->a[c]);
        w.next[c] = (int)fmin(fmax(cell, low[c] - 1), high[c]);
        w.low[c] = low[c];
        w.high[c] = high[c];
        w.to[c] = piece->a[c];
    }
    return w;
}

/* Whether there is a lattice line of coordinate c between the present point and the piece's end, and which. */
static int line_ahead(const struct solid_outline_walk *w, int c, double *line) {
    *line = w->next[c] + (w->step[c] > 0);
    return *line >= w->low[c] && *line <= w->high[c] && w->step[c] * (w->piece->b[c] - *line) > 0;
}

int solid_outline_walk_next(struct solid_outline_walk *w) {
    if (w->is_done) return 0;
    double line[2];
    const int x_ahead = line_ahead(w, 0, &line[0]), y_ahead = line_ahead(w, 1, &line[1]);
    for (int c = 0; c < 2; c++) {
        w->from[c] = w->to[c];
        w->cell[c] = w->next[c];
    }
    if (!x_ahead && !y_ahead) {
        for (int c = 0; c < 2; c++) w->to[c] = w->piece->b[c];
        return w->is_done = 1;
    }
    int c = !x_ahead;
    if (x_ahead && y_ahead) c = w->step[1] * (solid_outline_edge_at(w->piece, 0, line[0]) - line[1]) > 0;
    /* the other coordinate is kept in this cell despite rounding, so that no row takes a part of another */
    const int o = 1 - c, o_ahead = o == 0 ? x_ahead : y_ahead;
    const double end = o_ahead ? line[o] : w->piece->b[o], at = solid_outline_edge_at(w->piece, c, line[c]);
    w->to[c] = line[c];
    w->to[o] = fmin(fmax(at, fmin(w->from[o], end)), fmax(w->from[o], end));
    w->next[c] += w->step[c];
    return 1;
}
