/* Finds the lattice sites, cells or points that belong to a body and numbers them along a space-filling curve. */
#include "solid/body/sites.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/geometry/curve.h"
#include "solid/geometry/outline.h"

#include <math.h>
#include <stdlib.h>

static int in_shape(const struct solid_body *b, const double x[3], double spacing) {
    const double tiny = 1e-9 * spacing;
    if (b->shape == SOLID_BOX) {
        for (int c = 0; c < 3; c++)
            if (x[c] < b->low[c] - tiny || x[c] >= b->high[c] - tiny) return 0;
        return 1;
    }
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double r = x[c] - b->centre[c];
        if (b->shape == SOLID_CYLINDER && c == b->axis) {
            if (r < -b->length / 2 - tiny || r >= b->length / 2 - tiny) return 0;
        } else {
            r2 += r * r;
        }
    }
    return r2 < b->radius * b->radius;
}

/* Whether x is in the nearest of the cavities of the cubic array. */
static int in_cavity(const struct solid_body *b, const double x[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double r = (x[c] - b->cavity_centre[c]) / b->cavity_period;
        r2 += (r - rint(r)) * (r - rint(r));
    }
    return r2 * b->cavity_period * b->cavity_period < b->cavity_radius * b->cavity_radius;
}

int solid_sites_body_contains(const struct solid_body *b, const double x[3], double spacing) {
    return in_shape(b, x, spacing) && !(b->cavity_period > 0 && in_cavity(b, x));
}

static void bounds(const struct solid_body *b, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) {
        const double half = b->shape == SOLID_CYLINDER && c == b->axis ? b->length / 2 : b->radius;
        low[c] = b->shape == SOLID_BOX ? b->low[c] : b->centre[c] - half;
        high[c] = b->shape == SOLID_BOX ? b->high[c] : b->centre[c] + half;
    }
}

struct keyed {
    uint64_t key;
    long item;
};

static int by_key(const void *a, const void *b) {
    const struct keyed *x = a, *y = b;
    if (x->key != y->key) return x->key < y->key ? -1 : 1;
    return x->item < y->item ? -1 : x->item > y->item;
}

/* One byte for each site of the box of n[0] x n[1] x n[2] sites from low: 1 inside. Sets the body's count and
 * extent. */
static uint8_t *sites_inside(const struct solid_input *in, const struct solid_body *b, const int low[3], const int n[3],
                             struct solid_sites *t, int top[3]) {
    uint8_t *inside = memory_new(MEMORY_SOLID, (size_t)n[0] * (size_t)n[1] * (size_t)n[2], 1), *at = inside;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++, at++) {
                const int site[3] = {low[0] + i, low[1] + j, low[2] + k};
                double x[3];
                for (int c = 0; c < 3; c++) x[c] = in->origin[c] + (site[c] + 0.5) * in->spacing;
                if (!solid_sites_body_contains(b, x, in->spacing)) continue;
                *at = 1;
                for (int c = 0; c < 3; c++) {
                    if (site[c] < t->base[c] || t->count == 0) t->base[c] = site[c];
                    if (site[c] > top[c] || t->count == 0) top[c] = site[c];
                }
                t->count++;
            }
    return inside;
}

/* The shift of the rows that gives the fewest rows: in a sweep a full row and a partly filled one cost the same. */
static int best_shift(const uint8_t *inside, const int n[3]) {
    int best = 0;
    long fewest = -1;
    for (int shift = 0; shift < SOLID_ROW; shift++) {
        long rows = 0;
        for (long line = 0; line < (long)n[1] * n[2]; line++)
            for (int from = -shift; from < n[0]; from += SOLID_ROW) {
                int any = 0;
                for (int i = from < 0 ? 0 : from; i < from + SOLID_ROW && i < n[0]; i++) any |= inside[line * n[0] + i];
                rows += any;
            }
        if (fewest < 0 || rows < fewest) {
            fewest = rows;
            best = shift;
        }
    }
    return best;
}

static void fill_rows(struct solid_sites *t, const uint8_t *inside, const int n[3], int shift) {
    for (long line = 0; line < (long)n[1] * n[2]; line++)
        for (int i = 0; i < n[0]; i++)
            if (inside[line * n[0] + i])
                t->bits[line * t->rows[0] + (i + shift) / SOLID_ROW] |= (uint8_t)(1 << (i + shift) % SOLID_ROW);
}

static void number_rows(struct solid_sites *t) {
    const int rows = t->rows[0] * t->rows[1] * t->rows[2];
    struct keyed *row = memory_new(MEMORY_SOLID, (size_t)rows, sizeof *row);
    for (int r = 0; r < rows; r++) {
        if (!t->bits[r]) continue;
        const int i = r % t->rows[0], j = r / t->rows[0] % t->rows[1], k = r / t->rows[0] / t->rows[1];
        const uint32_t brick[3] = {(uint32_t)i, (uint32_t)j / SOLID_ROW, (uint32_t)k / SOLID_ROW};
        row[t->filled++] = (struct keyed){solid_curve_key(brick, 3), r};
    }
    qsort(row, (size_t)t->filled, sizeof *row, by_key);
    t->order = memory_new(MEMORY_SOLID, (size_t)t->filled + 1, sizeof *t->order);
    long id = t->first;
    for (int q = 0; q < t->filled; q++) {
        const int r = (int)row[q].item;
        t->order[q] = r;
        t->start[r] = id;
        id += __builtin_popcount(t->bits[r]);
    }
    memory_free(row);
}

/* Checks that a body with so many sites along c fits the periodic side, and sets the period. */
static void period_set(const struct solid_input *in, const struct solid_body *b, struct solid_sites *t, int c,
                       int sites, int reach) {
    if (!in->periodic[c]) return;
    const double period = in->length[c] / in->spacing;
    t->wrap[c] = (int)lrint(period);
    if (fabs(period - t->wrap[c]) > 1e-6 * period || t->wrap[c] <= reach)
        die_all(EXIT_CODE_SCENE,
                "solid.spacing = %g: the periodic length %g must be a whole number of spacings, more than %d",
                in->spacing, in->length[c], reach);
    if (sites > t->wrap[c])
        die_all(EXIT_CODE_SCENE, "solid body %s is longer than the period %g m and would overlap itself", b->name,
                in->length[c]);
}

static void cut_from_lattice(const struct solid_input *in, const struct solid_body *b, struct solid_sites *t,
                             int reach) {
    double low[3], high[3];
    int top[3] = {0}, n[3];
    bounds(b, low, high);
    for (int c = 0; c < 3; c++) {
        t->low[c] = (int)floor((low[c] - in->origin[c]) / in->spacing - 1);
        n[c] = (int)ceil((high[c] - in->origin[c]) / in->spacing + 1) - t->low[c] + 1;
        t->rows[c] = n[c];
    }
    uint8_t *inside = sites_inside(in, b, t->low, n, t, top);
    const int shift = best_shift(inside, n);
    t->low[0] -= shift;
    t->rows[0] = (n[0] + shift - 1) / SOLID_ROW + 1;
    const size_t rows = (size_t)t->rows[0] * (size_t)t->rows[1] * (size_t)t->rows[2];
    t->bits = memory_new(MEMORY_SOLID, rows, sizeof *t->bits);
    t->start = memory_new(MEMORY_SOLID, rows, sizeof *t->start);
    fill_rows(t, inside, n, shift);
    memory_free(inside);
    if (t->count == 0) return;
    for (int c = 0; c < 3; c++) period_set(in, b, t, c, top[c] - t->base[c] + 1, reach);
    number_rows(t);
}

/* Numbers points or cells in the order of their keys. */
static void number(struct solid_sites *t, struct keyed *key, long n) {
    qsort(key, (size_t)n, sizeof *key, by_key);
    t->count = n;
    t->point = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *t->point);
    for (long p = 0; p < n; p++) t->point[p] = key[p].item;
}

/* Finds the cells of a polygon. */
static void cut_from_plane(const struct solid_input *in, const struct solid_body *b, struct solid_sites *t, int reach) {
    struct solid_outline_cells *cells = solid_outline_cells(b->outline, b->outlines, in->origin, in->spacing);
    struct keyed *key = memory_new(MEMORY_SOLID, (size_t)cells->n + 1, sizeof *key);
    solid_outline_symmetry_cells(cells);
    for (long p = 0; p < cells->n; p++) {
        const struct solid_outline_cell *cell = &cells->cell[p];
        const uint32_t at[2] = {(uint32_t)(cell->i - cells->low[0]), (uint32_t)(cell->j - cells->low[1])};
        key[p] = (struct keyed){solid_curve_key(at, 2), p};
    }
    number(t, key, cells->n);
    memory_free(key);
    t->cell = memory_new(MEMORY_SOLID, (size_t)t->count + 1, sizeof *t->cell);
    t->area = memory_new(MEMORY_SOLID, (size_t)t->count + 1, sizeof *t->area);
    for (long i = 0; i < t->count; i++) {
        const struct solid_outline_cell *cell = &cells->cell[t->point[i]];
        t->cell[i][0] = cell->i;
        t->cell[i][1] = cell->j;
        t->area[i] = cell->area;
    }
    for (int c = 0; c < 2 && t->count > 0; c++) {
        t->base[c] = cells->low[c];
        period_set(in, b, t, c, cells->high[c] - cells->low[c] + 1, reach);
    }
    solid_outline_cells_free(cells);
}

static void number_points(const struct solid_input *in, const struct solid_body *b, struct solid_sites *t) {
    struct keyed *key = memory_new(MEMORY_SOLID, (size_t)b->points + 1, sizeof *key);
    double low[3] = {INFINITY, INFINITY, INFINITY};
    const int dim = solid_dim(in);
    for (long p = 0; p < b->points; p++)
        for (int c = 0; c < dim; c++) low[c] = fmin(low[c], b->point[c][p]);
    for (long p = 0; p < b->points; p++) {
        uint32_t cell[3];
        for (int c = 0; c < dim; c++) cell[c] = (uint32_t)((b->point[c][p] - low[c]) / in->spacing);
        key[p] = (struct keyed){solid_curve_key(cell, dim), p};
    }
    number(t, key, b->points);
    memory_free(key);
}

struct solid_sites *solid_sites_new(const struct solid_input *in, const struct solid_body *b, long first, int reach) {
    struct solid_sites *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    t->is_lattice = b->shape != SOLID_POINTS && b->shape != SOLID_POLYGON;
    t->first = first;
    if (t->is_lattice)
        cut_from_lattice(in, b, t, reach);
    else if (b->shape == SOLID_POLYGON)
        cut_from_plane(in, b, t, reach);
    else
        number_points(in, b, t);
    if (t->count == 0)
        die_all(EXIT_CODE_SCENE, "solid body %s holds no particle at spacing %g m", b->name, in->spacing);
    return t;
}

void solid_sites_free(struct solid_sites *t) {
    if (!t) return;
    memory_free(t->bits);
    memory_free(t->start);
    memory_free(t->order);
    memory_free(t->point);
    memory_free(t->cell);
    memory_free(t->area);
    memory_free(t);
}

long solid_sites_id(const struct solid_sites *t, const int site[3]) {
    int at[3];
    for (int c = 0; c < 3; c++) {
        at[c] = site[c];
        if (t->wrap[c]) {
            const int r = (site[c] - t->base[c]) % t->wrap[c];
            at[c] = t->base[c] + (r < 0 ? r + t->wrap[c] : r);
        }
        at[c] -= t->low[c];
        if (at[c] < 0 || at[c] >= (c == 0 ? SOLID_ROW : 1) * t->rows[c]) return -1;
    }
    const long row = ((long)at[2] * t->rows[1] + at[1]) * t->rows[0] + at[0] / SOLID_ROW;
    const unsigned bit = 1u << at[0] % SOLID_ROW;
    if (!(t->bits[row] & bit)) return -1;
    return t->start[row] + __builtin_popcount(t->bits[row] & (bit - 1));
}
