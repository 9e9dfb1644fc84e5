/* Contour lines of a field on a grid, and their CSV and VTK files. */
#include "postproc/data/contour.h"
#include "base/files/atomic_write.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>

/* Edges of the grid: number 2 node is the edge from a node along x, 2 node + 1 the one along y. A line crosses each
 * edge at most once. */
struct edges {
    const struct postproc_grid *g;
    double level;
    long *next; /* the next edge of the line, -1: none */
    char *entered;
};

static long node_of(const struct postproc_grid *g, int i, int j) { return (long)j * g->n[0] + i; }

static void join(struct edges *e, long from, long to) {
    e->next[from] = to;
    e->entered[to] = 1;
}

/*   3 --2-- 2     corners and sides of a square, counterclockwise;
 *   |       |     a line enters by a side on which, counterclockwise,
 *   3       1     the values fall below the level, and leaves by
 *   |       |     one on which they rise: higher values are to its left
 *   0 --0-- 1 */
static void square(struct edges *e, int i, int j) {
    const struct postproc_grid *g = e->g;
    const long a = node_of(g, i, j), up = a + g->n[0];
    const double v[4] = {g->value[a], g->value[a + 1], g->value[up + 1], g->value[up]};
    const long side[4] = {2 * a, 2 * (a + 1) + 1, 2 * up, 2 * a + 1};
    if (isnan(v[0] + v[1] + v[2] + v[3])) return;
    int above[4], falls[2], rises[2], n = 0, m = 0;
    for (int k = 0; k < 4; k++) above[k] = v[k] >= e->level;
    for (int k = 0; k < 4; k++) {
        const int b = above[(k + 1) % 4];
        if (above[k] && !b) falls[n++] = k;
        if (!above[k] && b) rises[m++] = k;
    }
    if (n == 0) return;
    if (n == 1) {
        join(e, side[falls[0]], side[rises[0]]);
        return;
    }
    /* saddle: round the two high corners, or, if the middle is high, round the two low ones */
    const int middle = (v[0] + v[1] + v[2] + v[3]) / 4 >= e->level;
    for (int k = 0; k < 2; k++) join(e, side[falls[k]], side[(falls[k] + (middle ? 1 : 3)) % 4]);
}

static void point_on(const struct edges *e, long edge, double x[2]) {
    const struct postproc_grid *g = e->g;
    const long a = edge / 2, b = a + (edge % 2 ? g->n[0] : 1);
    const double f = (e->level - g->value[a]) / (g->value[b] - g->value[a]);
    x[0] = g->origin[0] + ((double)(a % g->n[0]) + (edge % 2 ? 0 : f)) * g->h;
    x[1] = g->origin[1] + ((double)(a / g->n[0]) + (edge % 2 ? f : 0)) * g->h;
}

/* Appends the line that starts at an edge and removes its edges. */
static long follow(struct edges *e, struct postproc_contour *c, long start, long points) {
    long edge = start;
    c->first[c->lines++] = points;
    for (;;) {
        point_on(e, edge, c->x[points++]);
        const long next = e->next[edge];
        if (next < 0) break;
        e->next[edge] = -1;
        edge = next;
    }
    c->first[c->lines] = points;
    return points;
}

struct postproc_contour *postproc_contour_new(const struct postproc_grid *g, double level) {
    const long edges = 2L * g->n[0] * g->n[1];
    struct edges e = {.g = g, .level = level};
    e.next = memory_new(MEMORY_OUTPUT, (size_t)edges + 1, sizeof *e.next);
    e.entered = memory_new(MEMORY_OUTPUT, (size_t)edges + 1, 1);
    for (long k = 0; k < edges; k++) e.next[k] = -1;
    for (int j = 0; j + 1 < g->n[1]; j++)
        for (int i = 0; i + 1 < g->n[0]; i++) square(&e, i, j);
    long pieces = 0, points = 0;
    for (long k = 0; k < edges; k++) pieces += e.next[k] >= 0;
    struct postproc_contour *c = memory_new(MEMORY_OUTPUT, 1, sizeof *c);
    c->first = memory_new(MEMORY_OUTPUT, (size_t)pieces + 2, sizeof *c->first);
    c->x = memory_new(MEMORY_OUTPUT, 2 * (size_t)pieces + 2, sizeof *c->x);
    for (int closed = 0; closed < 2; closed++) /* first the open lines from their starts, then the closed ones */
        for (long k = 0; k < edges; k++)
            if (e.next[k] >= 0 && (closed || !e.entered[k])) points = follow(&e, c, k, points);
    MEMORY_FREE(e.next, e.entered);
    return c;
}

void postproc_contour_free(struct postproc_contour *c) {
    if (!c) return;
    MEMORY_FREE(c->first, c->x, c);
}

int postproc_contour_write_csv(const struct postproc_contour *c, const char *path) {
    FILE *f = atomic_write_open(path);
    if (!f) return -1;
    fputs("polyline,x,y\n#1,m,m\n", f);
    for (int k = 0; k < c->lines; k++)
        for (long i = c->first[k]; i < c->first[k + 1]; i++) fprintf(f, "%d,%.9g,%.9g\n", k, c->x[i][0], c->x[i][1]);
    return atomic_write_close(f, path, 0);
}

int postproc_contour_write_vtk(const struct postproc_contour *c, const char *path) {
    FILE *f = atomic_write_open(path);
    if (!f) return -1;
    const long points = c->lines ? c->first[c->lines] : 0;
    fprintf(f, "# vtk DataFile Version 3.0\ndamage contour\nASCII\nDATASET POLYDATA\nPOINTS %ld double\n", points);
    for (long i = 0; i < points; i++) fprintf(f, "%.9g %.9g 0\n", c->x[i][0], c->x[i][1]);
    fprintf(f, "LINES %d %ld\n", c->lines, points + c->lines);
    for (int k = 0; k < c->lines; k++) {
        fprintf(f, "%ld", c->first[k + 1] - c->first[k]);
        for (long i = c->first[k]; i < c->first[k + 1]; i++) fprintf(f, " %ld", i);
        fputc('\n', f);
    }
    return atomic_write_close(f, path, 0);
}
