/* Particles of a body outside the lattice store: positions, sizes, volumes, horizons, and a cell grid. */
#include "solid/body/cloud.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/body/sites.h"
#include "solid/law/weight.h"

#include <math.h>
#include <stdio.h>

enum {
    LATTICE_COLUMNS = 400
}; /* number of columns for partial volumes: accurate to 1e-6, as in the lattice
    * store */

/* Rounds to a multiple of 2^-20. */
static double rounded(double x) { return rint(x * 0x1p20) * 0x1p-20; }

static double size_of(double volume, int dim) { return rounded(dim == 3 ? cbrt(volume) : sqrt(volume)); }

static long cell_of(const struct solid_cloud *t, long i) {
    long cell = 0;
    for (int c = t->dim - 1; c >= 0; c--)
        cell = cell * t->cells.cells[c] + (long)((t->place[c][i] - t->cells.low[c]) / t->cells.width);
    return cell;
}

/* Sorts the particles into cells a third as wide as the longest bond, so that a search tests few particles that are too
 * far away. */
static void sort_into_cells(struct solid_cloud *t) {
    struct solid_cloud_cells *k = &t->cells;
    long cells = 1;
    k->width = t->longest_reach / 3;
    for (int c = 0; c < 3; c++) k->cells[c] = 1;
    for (int c = 0; c < t->dim; c++) {
        double high = -INFINITY;
        k->low[c] = INFINITY;
        for (long i = 0; i < t->n; i++) {
            k->low[c] = fmin(k->low[c], t->place[c][i]);
            high = fmax(high, t->place[c][i]);
        }
        k->cells[c] = (int)((high - k->low[c]) / k->width) + 1;
        cells *= k->cells[c];
    }
    k->start = memory_new(MEMORY_SOLID, (size_t)cells + 2, sizeof *k->start);
    k->item = memory_new(MEMORY_SOLID, (size_t)t->n + 1, sizeof *k->item);
    for (long i = 0; i < t->n; i++) k->start[cell_of(t, i) + 2]++;
    for (long q = 2; q < cells + 2; q++) k->start[q] += k->start[q - 1];
    for (long i = 0; i < t->n; i++) k->item[k->start[cell_of(t, i) + 1]++] = i;
}

struct solid_cloud *solid_cloud_new(const struct solid_cloud_input *in) {
    struct solid_cloud *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    t->dim = in->law.dim;
    t->n = in->n;
    t->first = in->first;
    t->spacing = in->spacing;
    t->unit = in->spacing * in->spacing * (t->dim == 3 ? in->spacing : in->thickness);
    t->law = in->law;
    t->law.table = solid_weight_table_new();
    snprintf(t->name, sizeof t->name, "%s", in->name ? in->name : "");
    for (int c = 0; c < t->dim; c++) {
        t->origin[c] = in->origin[c];
        t->period[c] = rounded(in->period[c] / in->spacing);
        t->place[c] = memory_new(MEMORY_SOLID, (size_t)t->n + 1, sizeof *t->place[c]);
        for (long i = 0; i < t->n; i++) t->place[c][i] = rounded(in->place[c][i]);
    }
    t->volume = memory_copy(MEMORY_SOLID, in->volume, (size_t)t->n, sizeof(double));
    t->size = memory_copy(MEMORY_SOLID, in->size ? in->size : in->volume, (size_t)t->n, sizeof(double));
    t->horizon = memory_copy(MEMORY_SOLID, in->horizon ? in->horizon : in->volume, (size_t)t->n, sizeof(double));
    double size = 0, horizon = 0;
    for (long i = 0; i < t->n; i++) {
        if (!(t->volume[i] > 0))
            die_all(EXIT_CODE_SCENE, "particle %ld of solid body %s has no volume (%g)", i, t->name,
                    t->volume[i] * t->unit);
        if (!in->size) t->size[i] = size_of(t->volume[i], t->dim);
        if (!in->horizon) t->horizon[i] = t->law.horizon;
        size = fmax(size, t->size[i]);
        horizon = fmax(horizon, t->horizon[i]);
    }
    t->longest_reach = horizon + M_SQRT1_2 * size; /* to the centre of a square whose corner is at the horizon */
    sort_into_cells(t);
    return t;
}

void solid_cloud_free(struct solid_cloud *t) {
    if (!t) return;
    solid_weight_table_free(t->law.table);
    void *const own[] = {t->place[0], t->place[1],    t->place[2],   t->size, t->volume,
                         t->horizon,  t->cells.start, t->cells.item, t};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
}

/* The input while it is put together, with [3 + 3] arrays of one number a particle. */
struct draft {
    struct solid_cloud_input in;
    double *place[3], *volume, *size, *horizon;
};

static void draft_begin(struct draft *d, const struct solid_input *in, const struct solid_body *body,
                        const struct solid_sites *sites) {
    *d = (struct draft){.in = {.name = body->name,
                               .n = sites->count,
                               .first = sites->first,
                               .spacing = in->spacing,
                               .thickness = in->thickness,
                               .law = solid_pair_law(in, &in->material[body->material])}};
    double **const of[] = {&d->place[0], &d->place[1], &d->place[2], &d->volume, &d->size, &d->horizon};
    for (size_t k = 0; k < sizeof of / sizeof of[0]; k++)
        *of[k] = memory_new(MEMORY_SOLID, (size_t)sites->count + 1, sizeof **of[k]);
    for (int c = 0; c < d->in.law.dim; c++) {
        d->in.place[c] = d->place[c];
        d->in.period[c] = in->periodic[c] ? in->length[c] : 0;
    }
    d->in.volume = d->volume;
}

static struct solid_cloud *draft_end(struct draft *d) {
    struct solid_cloud *cloud = solid_cloud_new(&d->in);
    void *const own[] = {d->place[0], d->place[1], d->place[2], d->volume, d->size, d->horizon};
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) memory_free(own[k]);
    return cloud;
}

struct solid_cloud *solid_cloud_points(const struct solid_input *in, const struct solid_body *body,
                                       const struct solid_sites *t) {
    struct draft d;
    draft_begin(&d, in, body, t);
    const int dim = d.in.law.dim;
    const double unit = in->spacing * in->spacing * (dim == 3 ? in->spacing : 1);
    for (int c = 0; c < dim; c++) {
        d.in.origin[c] = INFINITY;
        for (long i = 0; i < t->count; i++) d.in.origin[c] = fmin(d.in.origin[c], body->point[c][i]);
        for (long i = 0; i < t->count; i++)
            d.place[c][i] = (body->point[c][t->point[i]] - d.in.origin[c]) / in->spacing;
    }
    for (long i = 0; i < t->count; i++) d.volume[i] = body->point_volume[t->point[i]] / unit;
    if (body->point_horizon) {
        for (long i = 0; i < t->count; i++) d.horizon[i] = body->point_horizon[t->point[i]] / in->spacing;
        d.in.horizon = d.horizon;
    }
    return draft_end(&d);
}

struct solid_cloud *solid_cloud_lattice(const struct solid_input *in, const struct solid_body *body,
                                        const struct solid_sites *t) {
    struct draft d;
    draft_begin(&d, in, body, t);
    long i = 0;
    for (int q = 0; q < t->filled; q++) {
        const int row = t->order[q];
        const int site[3] = {t->low[0] + SOLID_ROW * (row % t->rows[0]), t->low[1] + row / t->rows[0] % t->rows[1],
                             t->low[2] + row / t->rows[0] / t->rows[1]};
        for (int k = 0; k < SOLID_ROW; k++) {
            if (!(t->bits[row] >> k & 1)) continue;
            for (int c = 0; c < 3; c++) d.place[c][i] = site[c] + (c == 0 ? k : 0) + 0.5;
            d.volume[i++] = 1;
        }
    }
    for (int c = 0; c < 3; c++) d.in.origin[c] = in->origin[c];
    d.in.law.columns = LATTICE_COLUMNS;
    return draft_end(&d);
}
