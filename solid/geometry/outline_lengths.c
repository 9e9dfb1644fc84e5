/* Divides the boundary between two points of an outline among the adjacent particles. */
#include "base/memory.h"
#include "solid/geometry/outline.h"
#include "solid/geometry/outline_edge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A point nearer to an edge than this is on it, in spacings. */
static const double ON_EDGE = 1e-6;

/* List of lengths while they are collected. */
struct collection {
    const struct solid_outline_cells *cells; /* NULL: all lattice cells */
    struct solid_outline_lengths *lengths;
    long capacity;
    int low[2], high[2]; /* bounds of the cells */
};

static void give(struct collection *to, long cell, double length) {
    struct solid_outline_lengths *l = to->lengths;
    MEMORY_MORE(MEMORY_SOLID, l->share, l->n, to->capacity);
    l->share[l->n++] = (struct solid_outline_share){cell, length};
}

/* Gives a length to the cell's own particle, or in equal parts to the nearest particles. */
static void share_out(struct collection *to, int i, int j, double length) {
    const long own = to->cells ? solid_outline_cells_at(to->cells, i, j) : solid_outline_key(i, j);
    if (!to->cells) {
        give(to, own, length);
        return;
    }
    if (own >= 0) {
        give(to, own, length);
        return;
    }
    long near[SOLID_OUTLINE_NEAR];
    int n = solid_outline_cells_near(to->cells, i, j, 1, 1, near);
    for (int reach = 1; n == 0; reach *= 2) n = solid_outline_cells_near(to->cells, i, j, reach, 0, near);
    for (int k = 0; k < n; k++) give(to, near[k], length / n);
}

/* Adds the part of an edge between two fractions, cell by cell. An edge along a line of the lattice belongs to the
 * cells on the side of the body. */
static void edge_shares(struct collection *to, const struct solid_outline_edge *edge, int sense, long double from,
                        long double end) {
    const struct solid_outline_edge part = solid_outline_edge_part(edge, from, end);
    const int low[2] = {to->low[0] - 1, to->low[1] - 1}, high[2] = {to->high[0] + 2, to->high[1] + 2};
    struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
    const int pieces = solid_outline_edge_split(&part, piece);
    for (int p = 0; p < pieces; p++) {
        const double *a = piece[p].a, *b = piece[p].b, inward[2] = {sense * (a[1] - b[1]), sense * (b[0] - a[0])};
        struct solid_outline_walk w = solid_outline_walk_begin(&piece[p], low, high);
        while (solid_outline_walk_next(&w)) {
            for (int c = 0; c < 2; c++)
                if (a[c] == b[c]) w.cell[c] = (int)floor(a[c] + copysign(ON_EDGE, inward[c]));
            share_out(to, w.cell[0], w.cell[1], solid_outline_edge_length(&piece[p], w.from, w.to));
        }
    }
}

/* The common part of a straight edge and the straight segment of the given length from p: fractions of the edge.
 * Returns the distance along the segment. */
static double overlap(const struct solid_outline_edge *edge, const struct solid_outline_edge *line, double length,
                      long double fraction[2]) {
    const double *end[2] = {edge->a, edge->b};
    long double at[2], off[2];
    for (int k = 0; k < 2; k++) {
        const long double dx = (line->b[0] - line->a[0]) / length, dy = (line->b[1] - line->a[1]) / length;
        const long double x = end[k][0] - line->a[0], y = end[k][1] - line->a[1];
        at[k] = x * dx + y * dy;
        off[k] = y * dx - x * dy;
    }
    const long double low = fmaxl(fminl(at[0], at[1]), 0), high = fminl(fmaxl(at[0], at[1]), length);
    if (high - low <= ON_EDGE) return 0;
    for (int k = 0; k < 2; k++) {
        fraction[k] = ((k ? high : low) - at[0]) / (at[1] - at[0]);
        if (fabsl(off[0] + fraction[k] * (off[1] - off[0])) > ON_EDGE) return 0;
    }
    if (fraction[0] > fraction[1]) {
        const long double swap = fraction[0];
        fraction[0] = fraction[1];
        fraction[1] = swap;
    }
    return (double)(high - low);
}

/* An edge, and the sense of its outline. */
struct sensed {
    struct solid_outline_edge edge;
    int sense;
};

/* If the boundary is straight from a to b, divides it among particles; else returns 0. */
static int straight(struct collection *to, const struct sensed *edge, long edges, const double a[2],
                    const double b[2]) {
    const struct solid_outline_edge line = solid_outline_edge_straight(a, b);
    const double length = hypot(b[0] - a[0], b[1] - a[1]);
    double covered = 0, gaps = ON_EDGE;
    long double fraction[2];
    for (long k = 0; k < edges; k++) {
        const double common = edge[k].edge.turn ? 0 : overlap(&edge[k].edge, &line, length, fraction);
        covered += common;
        gaps += common > 0 ? ON_EDGE : 0;
    }
    if (covered < length - gaps) return 0;
    for (long k = 0; k < edges; k++)
        if (!edge[k].edge.turn && overlap(&edge[k].edge, &line, length, fraction) > 0)
            edge_shares(to, &edge[k].edge, edge[k].sense, fraction[0], fraction[1]);
    return 1;
}

/* If a and b are on one arc, divides the part between them among particles; else returns 0. */
static int arc(struct collection *to, const struct sensed *edge, long edges, const double a[2], const double b[2]) {
    const struct sensed *found = NULL;
    long double fraction[2] = {0, 0};
    for (long k = 0; k < edges; k++) {
        const struct solid_outline_edge *e = &edge[k].edge;
        if (!e->turn || solid_outline_edge_distance(e, a) > ON_EDGE || solid_outline_edge_distance(e, b) > ON_EDGE)
            continue;
        const long double at_a = fminl(fmaxl(solid_outline_edge_fraction(e, a), 0), 1),
                          at_b = fminl(fmaxl(solid_outline_edge_fraction(e, b), 0), 1);
        const int body_on_left = (at_a < at_b) == (edge[k].sense > 0);
        if (found && !body_on_left) continue;
        found = &edge[k];
        fraction[0] = fminl(at_a, at_b);
        fraction[1] = fmaxl(at_a, at_b);
    }
    if (found) edge_shares(to, &found->edge, found->sense, fraction[0], fraction[1]);
    return found != NULL;
}

static int by_cell(const void *a, const void *b) {
    const struct solid_outline_share *x = a, *y = b;
    if (x->cell != y->cell) return x->cell < y->cell ? -1 : 1;
    return (x->length > y->length) - (x->length < y->length);
}

/* Adds up the lengths of each particle, in m. */
static void merge(struct solid_outline_lengths *lengths, double spacing) {
    struct solid_outline_share *share = lengths->share;
    long kept = 0;
    qsort(share, (size_t)lengths->n, sizeof *share, by_cell);
    for (long k = 0; k < lengths->n; k++)
        if (kept > 0 && share[kept - 1].cell == share[k].cell)
            share[kept - 1].length += share[k].length;
        else
            share[kept++] = share[k];
    for (long k = 0; k < kept; k++) share[k].length *= spacing;
    lengths->n = kept;
}

struct solid_outline_lengths *solid_outline_lengths(const struct solid_outline *outline, int n, const double origin[2],
                                                    double spacing, const struct solid_outline_cells *cells,
                                                    const double from[2], const double to[2], char *text, size_t size) {
    double a[2], b[2];
    long edges = 0;
    for (int c = 0; c < 2; c++) {
        a[c] = (double)(((long double)from[c] - origin[c]) / spacing);
        b[c] = (double)(((long double)to[c] - origin[c]) / spacing);
    }
    if (hypot(b[0] - a[0], b[1] - a[1]) <= ON_EDGE) {
        snprintf(text, size, "from (%g, %g) to (%g, %g) is not a part of the boundary", from[0], from[1], to[0], to[1]);
        return NULL;
    }
    if (cells && cells->n == 0) {
        snprintf(text, size, "there is not a particle");
        return NULL;
    }
    for (int l = 0; l < n; l++) edges += outline[l].corners;
    struct sensed *edge = memory_new(MEMORY_SOLID, (size_t)edges, sizeof *edge), *at = edge;
    for (int l = 0; l < n; l++) {
        const int sense = solid_outline_sense(&outline[l]);
        for (int k = 0; k < outline[l].corners; k++)
            *at++ = (struct sensed){solid_outline_edge(&outline[l], k, origin, spacing), sense};
    }
    struct solid_outline_lengths *lengths = memory_new(MEMORY_SOLID, 1, sizeof *lengths);
    struct collection collection = {.cells = cells, .lengths = lengths};
    double bounds[2][2];
    solid_outline_bounds(outline, n, bounds[0], bounds[1]);
    for (int c = 0; c < 2; c++) {
        collection.low[c] = cells ? cells->low[c] : (int)floor((bounds[0][c] - origin[c]) / spacing);
        collection.high[c] = cells ? cells->high[c] : (int)ceil((bounds[1][c] - origin[c]) / spacing);
    }
    const int found = straight(&collection, edge, edges, a, b) || arc(&collection, edge, edges, a, b);
    memory_free(edge);
    if (found) {
        merge(lengths, spacing);
        return lengths;
    }
    snprintf(text, size, "the boundary does not run straight, or in one arc, from (%g, %g) to (%g, %g)", from[0],
             from[1], to[0], to[1]);
    solid_outline_lengths_free(lengths);
    return NULL;
}

void solid_outline_lengths_free(struct solid_outline_lengths *lengths) {
    if (!lengths) return;
    MEMORY_FREE(lengths->share, lengths);
}
