/* Checks that the outlines bound a plate: closed curves that do not touch, pieces and holes nested in turn. */
#include "base/memory.h"
#include "solid/geometry/outline.h"
#include "solid/geometry/outline_edge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Tolerances: of lengths, as a fraction of the outlines' extent; of the two radii of an arc, as a fraction of the
 * radius. */
static const double TOUCH = 1e-9, RADII = 1e-6;

static double distance(const double a[2], const double b[2]) { return hypot(a[0] - b[0], a[1] - b[1]); }

static int has_arc(const struct solid_outline *o) {
    for (int k = 0; o->turn && k < o->corners; k++)
        if (o->turn[k]) return 1;
    return 0;
}

/* Whether all corners are on one line. */
static int is_flat(const struct solid_outline *o, double tolerance) {
    int far = 0;
    for (int k = 1; k < o->corners; k++)
        if (distance(o->corner[k], o->corner[0]) > distance(o->corner[far], o->corner[0])) far = k;
    const struct solid_outline_edge line = solid_outline_edge_straight(o->corner[0], o->corner[far]);
    for (int k = 1; k < o->corners; k++)
        if (solid_outline_edge_distance(&line, o->corner[k]) > tolerance) return 0;
    return 1;
}

static int curve_fault(const struct solid_outline *o, int number, double extent, char *text, size_t size) {
    const int arcs = has_arc(o), n = o->corners;
    if (n < 3 - arcs)
        return snprintf(text, size, "outline %d has %d corner%s, and needs at least 3 (2 with an arc)", number, n,
                        n == 1 ? "" : "s");
    for (int k = 0; k < n; k++) {
        const int next = (k + 1) % n;
        if (distance(o->corner[k], o->corner[next]) <= TOUCH * extent)
            return snprintf(text, size, "outline %d: corners %d and %d are the same", number, k + 1, next + 1);
        if (!arcs || !o->turn[k]) continue;
        const double a = distance(o->corner[k], o->centre[k]), b = distance(o->corner[next], o->centre[k]);
        if (!(fabs(a - b) <= RADII * fmax(a, b)))
            return snprintf(
                text, size,
                "outline %d: the arc of edge %d has its centre %g m from corner %d, but %g m from corner %d", number,
                k + 1, a, k + 1, b, next + 1);
    }
    if (!arcs && is_flat(o, TOUCH * extent)) return snprintf(text, size, "outline %d encloses no area", number);
    return 0;
}

struct placed {
    struct solid_outline_edge edge;
    double low[2], high[2];
    int outline, number, last; /* number of the outline's last edge */
};

static int by_low_x(const void *a, const void *b) {
    const double x = ((const struct placed *)a)->low[0], y = ((const struct placed *)b)->low[0];
    return (x > y) - (x < y);
}

static void place(struct placed *at, const struct solid_outline *outline, int n, const double origin[2],
                  double extent) {
    for (int l = 0; l < n; l++)
        for (int k = 0; k < outline[l].corners; k++, at++) {
            const struct solid_outline_edge e = solid_outline_edge(&outline[l], k, origin, extent);
            *at = (struct placed){.edge = e, .outline = l, .number = k, .last = outline[l].corners - 1};
            for (int c = 0; c < 2; c++) {
                const double r = (double)e.radius, centre = (double)e.centre[c];
                at->low[c] = (e.turn ? centre - r : fmin(e.a[c], e.b[c])) - TOUCH;
                at->high[c] = (e.turn ? centre + r : fmax(e.a[c], e.b[c])) + TOUCH;
            }
        }
}

/* The common corner of edges e and f, where e ends and f starts; NULL: none. */
static const double *corner_of(const struct placed *e, const struct placed *f) {
    const int follows = f->number == (e->number == e->last ? 0 : e->number + 1);
    return e->outline == f->outline && follows ? f->edge.a : NULL;
}

/* Whether two edges have a common point besides a common corner. Two arcs that touch at the corner cross again within
 * the square root of the radii's rounding error; such a crossing does not count. */
static int do_meet(const struct placed *e, const struct placed *f) {
    const double *shared[2] = {corner_of(e, f), corner_of(f, e)};
    const double near = 4 * TOUCH + 1e-8 * (double)fmaxl(e->edge.radius, f->edge.radius);
    double point[8][2];
    const int points = solid_outline_meet(&e->edge, &f->edge, TOUCH, point);
    for (int p = 0; p < points; p++) {
        int is_corner = 0;
        for (int k = 0; k < 2; k++)
            if (shared[k] && distance(point[p], shared[k]) <= near) is_corner = 1;
        if (!is_corner) return 1;
    }
    return 0;
}

static int before(const struct placed *a, const struct placed *b) {
    return a->outline != b->outline ? a->outline < b->outline : a->number < b->number;
}

/* Reports the first pair of edges that meet, by outline and edge. */
static int meeting_fault(const struct placed *edge, long edges, char *text, size_t size) {
    const struct placed *first = NULL, *second = NULL;
    for (long p = 0; p < edges; p++)
        for (long q = p + 1; q < edges && edge[q].low[0] <= edge[p].high[0]; q++) {
            if (edge[q].low[1] > edge[p].high[1] || edge[p].low[1] > edge[q].high[1]) continue;
            const int in_order = before(&edge[p], &edge[q]);
            const struct placed *e = &edge[in_order ? p : q], *f = &edge[in_order ? q : p];
            if (first && (before(first, e) || (first == e && before(second, f)))) continue;
            if (!do_meet(e, f)) continue;
            first = e;
            second = f;
        }
    if (!first) return 0;
    if (first->outline == second->outline)
        return snprintf(text, size, "outline %d crosses or touches itself: edges %d and %d", first->outline + 1,
                        first->number + 1, second->number + 1);
    return snprintf(text, size, "outlines %d and %d cross or touch: edge %d of the one, edge %d of the other",
                    first->outline + 1, second->outline + 1, first->number + 1, second->number + 1);
}

/* The outlines do not meet, so that one corner tells whether a curve is inside another. Pieces and holes must alternate
 * from the outside in. */
static int nesting_fault(const struct solid_outline *outline, int n, double (*bounds)[2][2], double extent, char *text,
                         size_t size) {
    for (int l = 0; l < n; l++) solid_outline_bounds(&outline[l], 1, bounds[l][0], bounds[l][1]);
    for (int l = 0; l < n; l++) {
        int round[2] = {0, 0}, last[2] = {0, 0}; /* numbers of pieces and of holes that contain this one */
        const double *x = outline[l].corner[0];
        for (int m = 0; m < n; m++) {
            if (m == l || x[0] < bounds[m][0][0] || x[0] > bounds[m][1][0] || x[1] < bounds[m][0][1] ||
                x[1] > bounds[m][1][1] || !solid_outline_parity(&outline[m], 1, x, extent))
                continue;
            round[outline[m].is_hole != 0]++;
            last[outline[m].is_hole != 0] = m + 1;
        }
        if (outline[l].is_hole && round[0] == 0)
            return snprintf(text, size, "outline %d is a hole outside every piece", l + 1);
        if (outline[l].is_hole && round[0] <= round[1])
            return snprintf(text, size, "outline %d is a hole in the hole of outline %d", l + 1, last[1]);
        if (!outline[l].is_hole && round[0] > round[1])
            return snprintf(text, size, "outlines %d and %d are pieces that overlap", l + 1, last[0]);
    }
    return 0;
}

int solid_outline_fault(const struct solid_outline *outline, int n, char *text, size_t size) {
    if (n < 1) return snprintf(text, size, "there is no outline");
    long edges = 0;
    double extent = 0;
    const double *origin = outline[0].corners > 0 ? outline[0].corner[0] : (const double[2]){0, 0};
    for (int l = 0; l < n; l++) {
        edges += outline[l].corners;
        for (int k = 0; k < outline[l].corners; k++) extent = fmax(extent, distance(outline[l].corner[k], origin));
    }
    for (int l = 0; l < n; l++)
        if (curve_fault(&outline[l], l + 1, extent, text, size)) return 1;
    struct placed *edge = memory_new(MEMORY_SOLID, (size_t)edges, sizeof *edge);
    double(*bounds)[2][2] = memory_new(MEMORY_SOLID, (size_t)n, sizeof *bounds);
    place(edge, outline, n, origin, extent);
    qsort(edge, (size_t)edges, sizeof *edge, by_low_x);
    const int fault = meeting_fault(edge, edges, text, size) || nesting_fault(outline, n, bounds, extent, text, size);
    MEMORY_FREE(edge, bounds);
    return fault;
}
