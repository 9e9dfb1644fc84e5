/* Particles of a body outside the lattice store: positions, sizes, volumes, horizons, and a cell grid. */
#include "solid/body/bricks.h"
#include "solid/body/cloud.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/body/perturb.h"
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

static long cell_of(const struct solid_cloud *cloud, long i) {
    long cell = 0;
    for (int c = cloud->dim - 1; c >= 0; c--)
        cell = cell * cloud->cells.cells[c] + (long)((cloud->place[c][i] - cloud->cells.low[c]) / cloud->cells.width);
    return cell;
}

static double cells_of(const double extent[3], double width) {
    double cells = 1;
    for (int c = 0; c < 3; c++) cells *= floor(extent[c] / width) + 1;
    return cells;
}

/* Sorts the particles into cells a third as wide as the longest bond, so that a search tests few particles that are too
 * far away. Cells are wider where most of them would be empty, as between particles that are far apart. */
static void sort_into_cells(struct solid_cloud *cloud) {
    struct solid_cloud_cells *k = &cloud->cells;
    const double most = 64.0 * (double)cloud->n + 0x1p20;
    double extent[3] = {0}, cells;
    for (int c = 0; c < cloud->dim; c++) {
        double high = -INFINITY;
        k->low[c] = INFINITY;
        for (long i = 0; i < cloud->n; i++) {
            k->low[c] = fmin(k->low[c], cloud->place[c][i]);
            high = fmax(high, cloud->place[c][i]);
        }
        extent[c] = high - k->low[c];
    }
    k->width = cloud->longest_reach / 3;
    while ((cells = cells_of(extent, k->width)) > most) k->width *= 2;
    for (int c = 0; c < 3; c++) k->cells[c] = (int)(extent[c] / k->width) + 1;
    k->start = memory_new(MEMORY_SOLID, (size_t)cells + 2, sizeof *k->start);
    k->item = memory_new(MEMORY_SOLID, (size_t)cloud->n + 1, sizeof *k->item);
    for (long i = 0; i < cloud->n; i++) k->start[cell_of(cloud, i) + 2]++;
    for (long q = 2; q < (long)cells + 2; q++) k->start[q] += k->start[q - 1];
    for (long i = 0; i < cloud->n; i++) k->item[k->start[cell_of(cloud, i) + 1]++] = i;
}

struct solid_cloud *solid_cloud_new(const struct solid_cloud_input *in) {
    struct solid_cloud *cloud = memory_new(MEMORY_SOLID, 1, sizeof *cloud);
    cloud->dim = in->law.dim;
    cloud->n = in->n;
    cloud->first = in->first;
    cloud->spacing = in->spacing;
    cloud->unit = in->spacing * in->spacing * (cloud->dim == 3 ? in->spacing : in->thickness);
    cloud->law = in->law;
    cloud->law.table = solid_weight_table_new();
    snprintf(cloud->name, sizeof cloud->name, "%s", in->name ? in->name : "");
    for (int c = 0; c < cloud->dim; c++) {
        cloud->origin[c] = in->origin[c];
        cloud->period[c] = rounded(in->period[c] / in->spacing);
        cloud->place[c] = memory_new(MEMORY_SOLID, (size_t)cloud->n + 1, sizeof *cloud->place[c]);
        for (long i = 0; i < cloud->n; i++) cloud->place[c][i] = rounded(in->place[c][i]);
    }
    cloud->volume = memory_copy(MEMORY_SOLID, in->volume, (size_t)cloud->n, sizeof(double));
    cloud->size = memory_copy(MEMORY_SOLID, in->size ? in->size : in->volume, (size_t)cloud->n, sizeof(double));
    cloud->horizon =
        memory_copy(MEMORY_SOLID, in->horizon ? in->horizon : in->volume, (size_t)cloud->n, sizeof(double));
    double size = 0, horizon = 0;
    for (long i = 0; i < cloud->n; i++) {
        if (!(cloud->volume[i] > 0))
            die_all(EXIT_CODE_SCENE, "particle %ld of solid body %s has no volume (%g)", i, cloud->name,
                    cloud->volume[i] * cloud->unit);
        if (!in->size) cloud->size[i] = size_of(cloud->volume[i], cloud->dim);
        if (!in->horizon) cloud->horizon[i] = cloud->law.horizon;
        size = fmax(size, cloud->size[i]);
        horizon = fmax(horizon, cloud->horizon[i]);
    }
    cloud->longest_reach = horizon + M_SQRT1_2 * size; /* to the centre of a square whose corner is at the horizon */
    sort_into_cells(cloud);
    return cloud;
}

void solid_cloud_free(struct solid_cloud *cloud) {
    if (!cloud) return;
    solid_weight_table_free(cloud->law.table);
    MEMORY_FREE(cloud->place[0], cloud->place[1], cloud->place[2], cloud->size, cloud->volume, cloud->horizon,
                cloud->cells.start, cloud->cells.item, cloud);
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
    double **const arrays[] = {&d->place[0], &d->place[1], &d->place[2], &d->volume, &d->size, &d->horizon};
    for (size_t k = 0; k < sizeof arrays / sizeof arrays[0]; k++)
        *arrays[k] = memory_new(MEMORY_SOLID, (size_t)sites->count + 1, sizeof **arrays[k]);
    for (int c = 0; c < d->in.law.dim; c++) {
        d->in.place[c] = d->place[c];
        d->in.period[c] = in->periodic[c] ? in->length[c] : 0;
    }
    d->in.volume = d->volume;
}

static struct solid_cloud *draft_end(struct draft *d) {
    struct solid_cloud *cloud = solid_cloud_new(&d->in);
    MEMORY_FREE(d->place[0], d->place[1], d->place[2], d->volume, d->size, d->horizon);
    return cloud;
}

struct solid_cloud *solid_cloud_points(const struct solid_input *in, const struct solid_body *body,
                                       const struct solid_sites *sites) {
    struct draft d;
    draft_begin(&d, in, body, sites);
    const int dim = d.in.law.dim;
    const double unit = in->spacing * in->spacing * (dim == 3 ? in->spacing : 1);
    for (int c = 0; c < dim; c++) {
        d.in.origin[c] = INFINITY;
        for (long i = 0; i < sites->count; i++) d.in.origin[c] = fmin(d.in.origin[c], body->point[c][i]);
        for (long i = 0; i < sites->count; i++)
            d.place[c][i] = (body->point[c][sites->point[i]] - d.in.origin[c]) / in->spacing +
                            solid_perturb(body, sites->point[i], 0, c);
    }
    for (long i = 0; i < sites->count; i++) d.volume[i] = body->point_volume[sites->point[i]] / unit;
    if (body->point_horizon) {
        for (long i = 0; i < sites->count; i++) d.horizon[i] = body->point_horizon[sites->point[i]] / in->spacing;
        d.in.horizon = d.horizon;
    }
    return draft_end(&d);
}

struct solid_cloud *solid_cloud_lattice(const struct solid_input *in, const struct solid_body *body,
                                        const struct solid_sites *sites) {
    struct draft d;
    draft_begin(&d, in, body, sites);
    long i = 0;
    for (struct solid_bricks_walk row = {0}; solid_bricks_next(sites, &row);)
        for (int k = 0; k < SOLID_ROW; k++) {
            if (!(row.bits >> k & 1)) continue;
            for (int c = 0; c < 3; c++) d.place[c][i] = row.site[c] + (c == 0 ? k : 0) + 0.5;
            d.volume[i++] = 1;
        }
    for (int c = 0; c < 3; c++) d.in.origin[c] = in->origin[c];
    d.in.law.columns = LATTICE_COLUMNS;
    return draft_end(&d);
}
