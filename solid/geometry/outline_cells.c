/* Divides a plate into lattice cells and computes each particle's area by Green's theorem. */
#include "base/die.h"
#include "base/memory.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/outline.h"
#include "solid/geometry/outline_edge.h"

#include <math.h>
#include <stdlib.h>

/* An area less than this is not a particle, in cells. */
static const double NOTHING = 1e-12;

/* The contribution of edges to a cell. Cells of a row are summed up from the left:
 *
 *      area of cell i = sum of (x - (i + 1)) dy in it - sum of dy left of it          (Green)
 *      its centre is inside if left of it an odd number of edges crosses the row's middle */
struct hit {
    int i, j;
    double area, rise;   /* integral of (x - (i + 1)) dy and of dy, with the body on the left */
    int crossings, left; /* of the row's middle; those left of the cell's centre */
    double away;         /* distance of the centre from the edge, the least */
};

static struct hit hit_of(const struct solid_outline_edge *piece, const struct solid_outline_walk *w, int sense) {
    const double centre[2] = {w->cell[0] + 0.5, w->cell[1] + 0.5};
    const int crosses = (w->from[1] <= centre[1]) != (w->to[1] <= centre[1]);
    return (struct hit){
        .i = w->cell[0],
        .j = w->cell[1],
        .area = sense * solid_outline_edge_integral(piece, w->from, w->to, w->cell[0] + 1),
        .rise = sense * (w->to[1] - w->from[1]),
        .crossings = crosses,
        .left = crosses && solid_outline_edge_at(piece, 1, centre[1]) < centre[0],
        .away = solid_outline_edge_distance(piece, centre),
    };
}

/* The contributions of all edges, in their order; hit may be NULL. */
static long hits_of(const struct solid_outline *outline, int n, const double origin[2], double spacing,
                    const int low[2], const int high[2], struct hit *hit) {
    long hits = 0;
    for (int l = 0; l < n; l++) {
        const int sense = solid_outline_sense(&outline[l]);
        for (int k = 0; k < outline[l].corners; k++) {
            struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
            const int pieces = solid_outline_edge_pieces(&outline[l], k, origin, spacing, piece);
            for (int p = 0; p < pieces; p++) {
                struct solid_outline_walk w = solid_outline_walk_begin(&piece[p], low, high);
                for (; solid_outline_walk_next(&w); hits++)
                    if (hit) hit[hits] = hit_of(&piece[p], &w, sense);
            }
        }
    }
    return hits;
}

static int by_row(const void *a, const void *b) {
    const struct hit *x = a, *y = b;
    return x->j != y->j ? (x->j > y->j) - (x->j < y->j) : (x->i > y->i) - (x->i < y->i);
}

/* Adds up the contributions to each cell. */
static long merge(struct hit *hit, long hits) {
    long kept = 0;
    qsort(hit, (size_t)hits, sizeof *hit, by_row);
    for (long k = 0; k < hits; k++) {
        struct hit *last = &hit[kept - 1];
        if (kept == 0 || by_row(last, &hit[k]) != 0) {
            hit[kept++] = hit[k];
            continue;
        }
        last->area += hit[k].area;
        last->rise += hit[k].rise;
        last->crossings += hit[k].crossings;
        last->left += hit[k].left;
        last->away = fmin(last->away, hit[k].away);
    }
    return kept;
}

/* The cells that contain a part of the body, or whose centre is in it, in order; cell may be NULL. */
static long cells_of(const struct hit *hit, long hits, struct solid_outline_cell *cell) {
    long n = 0;
    for (long k = 0; k < hits;) {
        const int j = hit[k].j;
        double full = 0; /* area of a cell at this place that no edge enters */
        int crossed = 0;
        for (; k < hits && hit[k].j == j; k++) {
            const struct hit *h = &hit[k];
            const int is_inside = solid_on_surface_is_on(h->away, 1) || ((crossed + h->left) & 1);
            const double area = full + h->area;
            if (is_inside || area > 0) {
                if (cell) cell[n] = (struct solid_outline_cell){h->i, j, is_inside, fmax(area, 0)};
                n++;
            }
            full -= h->rise;
            crossed += h->crossings;
            if (full < 0.5 || k + 1 == hits || hit[k + 1].j != j) continue;
            for (int i = h->i + 1; i < hit[k + 1].i; i++, n++)
                if (cell) cell[n] = (struct solid_outline_cell){i, j, 1, full};
        }
    }
    return n;
}

/* Counts the centres on the boundary, and finds the nearest of the others. */
static void look_at_centres(struct solid_outline_cells *cells, const struct hit *hit, long hits) {
    cells->gap = 0.5;
    for (long k = 0; k < hits; k++)
        if (solid_on_surface_is_on(hit[k].away, 1))
            cells->on_edge++;
        else
            cells->gap = fmin(cells->gap, hit[k].away);
}

/* Finds the rows of the present cells. */
static void index_rows(struct solid_outline_cells *cells) {
    const struct solid_outline_cell *cell = cells->cell;
    const long n = cells->n;
    cells->low[0] = n > 0 ? cell[0].i : 0;
    cells->high[0] = n > 0 ? cell[0].i : -1;
    cells->low[1] = n > 0 ? cell[0].j : 0;
    cells->high[1] = n > 0 ? cell[n - 1].j : -1;
    const int rows = cells->high[1] - cells->low[1] + 1;
    memory_free(cells->row);
    cells->row = memory_new(MEMORY_SOLID, (size_t)rows + 1, sizeof *cells->row);
    for (long k = 0; k < n; k++) {
        if (cell[k].i < cells->low[0]) cells->low[0] = cell[k].i;
        if (cell[k].i > cells->high[0]) cells->high[0] = cell[k].i;
        cells->row[cell[k].j - cells->low[1] + 1]++;
    }
    for (int r = 0; r < rows; r++) cells->row[r + 1] += cells->row[r];
}

long solid_outline_cells_at(const struct solid_outline_cells *cells, int i, int j) {
    if (j < cells->low[1] || j > cells->high[1]) return -1;
    long from = cells->row[j - cells->low[1]], to = cells->row[j - cells->low[1] + 1] - 1;
    while (from <= to) {
        const long middle = (from + to) / 2;
        if (cells->cell[middle].i == i) return middle;
        if (cells->cell[middle].i < i)
            from = middle + 1;
        else
            to = middle - 1;
    }
    return -1;
}

int solid_outline_cells_near(const struct solid_outline_cells *cells, int i, int j, int reach, int only_inside,
                             long near[SOLID_OUTLINE_NEAR]) {
    long nearest = 0;
    int n = 0;
    for (int dj = -reach; dj <= reach; dj++)
        for (int di = -reach; di <= reach; di++) {
            const long away = (long)di * di + (long)dj * dj;
            if (away == 0 || (n > 0 && away > nearest)) continue;
            const long k = solid_outline_cells_at(cells, i + di, j + dj);
            if (k < 0 || (only_inside && !cells->cell[k].is_inside)) continue;
            if (away < nearest) n = 0;
            nearest = away;
            if (n < SOLID_OUTLINE_NEAR) near[n++] = k;
        }
    return n;
}

/* Gives the areas of cells with their centre outside to adjacent particles. */
static void hand_over(struct solid_outline_cells *cells) {
    for (long k = 0; k < cells->n; k++) {
        struct solid_outline_cell *from = &cells->cell[k];
        long near[SOLID_OUTLINE_NEAR];
        if (from->is_inside) continue;
        const int shares = solid_outline_cells_near(cells, from->i, from->j, 1, 1, near);
        for (int s = 0; s < shares; s++) cells->cell[near[s]].area += from->area / shares;
        if (shares > 0) from->area = 0;
    }
    long kept = 0;
    for (long k = 0; k < cells->n; k++)
        if (cells->cell[k].area >= NOTHING) cells->cell[kept++] = cells->cell[k];
    cells->n = kept;
    index_rows(cells);
}

/* The box of the cells that the outlines reach. */
static void box_of(const struct solid_outline *outline, int n, const double origin[2], double spacing, int low[2],
                   int high[2]) {
    double from[2], to[2];
    solid_outline_bounds(outline, n, from, to);
    for (int c = 0; c < 2; c++) {
        const double first = floor((from[c] - origin[c]) / spacing) - 1, last = ceil((to[c] - origin[c]) / spacing) + 1;
        if (!(fabs(first) < 0x1p30 && fabs(last) < 0x1p30))
            die_all(EXIT_CODE_SCENE, "a plate from %g m to %g m has too many cells of %g m", from[c], to[c], spacing);
        low[c] = (int)first;
        high[c] = (int)last;
    }
}

struct solid_outline_cells *solid_outline_cells(const struct solid_outline *outline, int n, const double origin[2],
                                                double spacing) {
    int low[2], high[2];
    box_of(outline, n, origin, spacing, low, high);
    long hits = hits_of(outline, n, origin, spacing, low, high, NULL);
    struct hit *hit = memory_new(MEMORY_SOLID, (size_t)hits, sizeof *hit);
    hits_of(outline, n, origin, spacing, low, high, hit);
    hits = merge(hit, hits);
    struct solid_outline_cells *cells = memory_new(MEMORY_SOLID, 1, sizeof *cells);
    cells->n = cells_of(hit, hits, NULL);
    cells->cell = memory_new(MEMORY_SOLID, (size_t)cells->n, sizeof *cells->cell);
    cells_of(hit, hits, cells->cell);
    look_at_centres(cells, hit, hits);
    memory_free(hit);
    index_rows(cells);
    hand_over(cells);
    return cells;
}

void solid_outline_cells_free(struct solid_outline_cells *cells) {
    if (!cells) return;
    MEMORY_FREE(cells->cell, cells->row, cells);
}
