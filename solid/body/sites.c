/* Finds the lattice sites, cells or points that belong to a body and numbers them by halves of the body. */
#include "solid/body/sites.h"
#include "solid/body/bricks.h"
#include "base/die.h"
#include "base/machine.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/geometry/compound.h"
#include "solid/geometry/bisect.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/outline.h"
#include "solid/geometry/shape.h"
#include "solid/body/sites_image.h"

#include <math.h>
#include <stdlib.h>

/* Records a lattice point's depth below the body's surface. */
static void note(struct solid_sites *sites, double depth, const struct solid_compound *compound) {
    if (solid_on_surface_is_on(depth, compound->spacing))
        sites->on_surface++;
    else
        sites->gap = fmin(sites->gap, depth == -INFINITY ? solid_compound_unseen(compound) : fabs(depth));
}

/* One byte for each site of the box of n[0] x n[1] x n[2] sites from low: 1 inside. Sets the body's count and
 * extent, and who lies on its surface. */
static uint8_t *sites_inside(const struct solid_input *in, struct solid_compound *compound, const int low[3],
                             const int n[3], struct solid_sites *sites, int top[3]) {
    uint8_t *inside = memory_new(MEMORY_SOLID, (size_t)n[0] * (size_t)n[1] * (size_t)n[2], 1), *at = inside;
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++, at++) {
                const int site[3] = {low[0] + i, low[1] + j, low[2] + k};
                double x[3];
                for (int c = 0; c < 3; c++) x[c] = in->origin[c] + (site[c] + 0.5) * in->spacing;
                const double depth = solid_compound_depth(compound, x);
                note(sites, depth, compound);
                if (!solid_on_surface_is_inside(depth, in->spacing)) continue;
                *at = 1;
                for (int c = 0; c < 3; c++) {
                    if (site[c] < sites->base[c] || sites->count == 0) sites->base[c] = site[c];
                    if (site[c] > top[c] || sites->count == 0) top[c] = site[c];
                }
                sites->count++;
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

/* The shifts along y and z that give a plane of bricks through the middle. */
static void middle_shift(const uint8_t *inside, const int n[3], int shift[3]) {
    long *layer[3] = {NULL, memory_new(MEMORY_SOLID, (size_t)n[1], sizeof(long)),
                      memory_new(MEMORY_SOLID, (size_t)n[2], sizeof(long))};
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++) {
            long count = 0;
            for (int i = 0; i < n[0]; i++) count += inside[((long)k * n[1] + j) * n[0] + i];
            layer[1][j] += count;
            layer[2][k] += count;
        }
    for (int c = 1; c < 3; c++) {
        shift[c] = solid_bricks_shift(layer[c], n[c]);
        memory_free(layer[c]);
    }
}

static void fill_rows(struct solid_sites *sites, const uint8_t *inside, const int n[3], const int shift[3]) {
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++)
                if (inside[((long)k * n[1] + j) * n[0] + i])
                    sites->bits[solid_bricks_row(sites, (i + shift[0]) / SOLID_ROW, j + shift[1], k + shift[2])] |=
                        (uint8_t)(1 << (i + shift[0]) % SOLID_ROW);
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

/* Dies if one byte for each site within the body's bounds, on each rank, is more than the machine's memory. */
static void memory_check(const struct solid_input *in, const struct solid_body *body, const int n[3]) {
    const double sites = (double)n[0] * n[1] * n[2], has = (double)machine_memory();
    if (sites * fmin(par_size(), machine_cores()) > has)
        die_all(
            EXIT_CODE_SCENE,
            "solid body %s: its bounds hold %.3g sites of spacing %g m; a byte for each on every rank takes %.3g GB, "
            "and this machine has %.3g GB",
            body->name, sites, in->spacing, 1e-9 * sites * fmin(par_size(), machine_cores()), 1e-9 * has);
}

static void cut_from_lattice(const struct solid_input *in, const struct solid_body *body, struct solid_sites *sites,
                             int reach) {
    struct solid_compound *compound = solid_compound_new(in, body);
    int top[3] = {0}, n[3];
    for (int c = 0; c < 3; c++) {
        sites->low[c] = (int)floor((compound->low[c] - in->origin[c]) / in->spacing - 1);
        n[c] = (int)ceil((compound->high[c] - in->origin[c]) / in->spacing + 1) - sites->low[c] + 1;
        if (compound->is_wrapped[c]) {
            sites->low[c] = (int)ceil(-in->origin[c] / in->spacing - 0.5 - SOLID_ON_SURFACE);
            n[c] = (int)lrint(in->length[c] / in->spacing);
        }
        sites->rows[c] = n[c];
    }
    memory_check(in, body, n);
    uint8_t *inside = sites_inside(in, compound, sites->low, n, sites, top);
    sites->tested = compound->tested;
    int shift[3] = {best_shift(inside, n)};
    middle_shift(inside, n, shift);
    for (int c = 0; c < 3; c++) {
        sites->low[c] -= shift[c];
        sites->rows[c] = c == 0 ? (n[0] + shift[0] - 1) / SOLID_ROW + 1 : n[c] + shift[c];
    }
    solid_bricks_new(sites);
    fill_rows(sites, inside, n, shift);
    memory_free(inside);
    const double *low = compound->low, *high = compound->high;
    if (sites->count == 0)
        die_all(EXIT_CODE_SCENE,
                "solid body %s holds no particle at spacing %g m: it reaches from (%g, %g, %g) to (%g, %g, %g) m",
                body->name, in->spacing, low[0], low[1], low[2], high[0], high[1], high[2]);
    solid_compound_free(compound);
    for (int c = 0; c < 3; c++) period_set(in, body, sites, c, top[c] - sites->base[c] + 1, reach);
}

static void cut_from_image(const struct solid_input *in, const struct solid_body *body, struct solid_sites *sites,
                           int reach) {
    int top[3] = {0};
    solid_sites_image(body->voxels, sites, top);
    for (int c = 0; c < 3 && sites->count > 0; c++) period_set(in, body, sites, c, top[c] - sites->base[c] + 1, reach);
}

static struct solid_bisect_item item_at(int i, int j, int k, long item) {
    return (struct solid_bisect_item){.at = {i, j, k}, .weight = 1, .high = {1, 1, 1}, .item = item};
}

/* Numbers points or cells, one or more a brick of one site. */
static void number(struct solid_sites *sites, struct solid_bisect_item *item, long n, const int is_ring[3]) {
    solid_bisect_order(item, n, 1, is_ring, -1);
    sites->count = n;
    sites->point = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *sites->point);
    for (long p = 0; p < n; p++) sites->point[p] = item[p].item;
}

/* Finds the cells of a polygon. */
static void cut_from_plane(const struct solid_input *in, const struct solid_body *body, struct solid_sites *sites,
                           int reach) {
    struct solid_outline_cells *cells = solid_outline_cells(body->outline, body->outlines, in->origin, in->spacing);
    struct solid_bisect_item *item = memory_new(MEMORY_SOLID, (size_t)cells->n + 1, sizeof *item);
    int is_ring[3] = {0};
    solid_outline_symmetry_cells(cells);
    for (long p = 0; p < cells->n; p++) {
        const struct solid_outline_cell *cell = &cells->cell[p];
        item[p] = item_at(cell->i - cells->low[0], cell->j - cells->low[1], 0, p);
    }
    for (int c = 0; c < 2 && cells->n > 0; c++) {
        sites->base[c] = cells->low[c];
        period_set(in, body, sites, c, cells->high[c] - cells->low[c] + 1, reach);
        is_ring[c] = sites->wrap[c] > 0 && sites->wrap[c] - (cells->high[c] - cells->low[c] + 1) < SOLID_ROW;
    }
    number(sites, item, cells->n, is_ring);
    sites->on_surface = cells->on_edge;
    sites->gap = cells->gap * in->spacing;
    memory_free(item);
    sites->cell = memory_new(MEMORY_SOLID, (size_t)sites->count + 1, sizeof *sites->cell);
    sites->area = memory_new(MEMORY_SOLID, (size_t)sites->count + 1, sizeof *sites->area);
    for (long i = 0; i < sites->count; i++) {
        const struct solid_outline_cell *cell = &cells->cell[sites->point[i]];
        sites->cell[i][0] = cell->i;
        sites->cell[i][1] = cell->j;
        sites->area[i] = cell->area;
    }
    solid_outline_cells_free(cells);
}

static void number_points(const struct solid_input *in, const struct solid_body *body, struct solid_sites *sites) {
    struct solid_bisect_item *item = memory_new(MEMORY_SOLID, (size_t)body->points + 1, sizeof *item);
    double low[3] = {INFINITY, INFINITY, INFINITY};
    const int dim = solid_dim(in);
    for (long p = 0; p < body->points; p++)
        for (int c = 0; c < dim; c++) low[c] = fmin(low[c], body->point[c][p]);
    for (long p = 0; p < body->points; p++) {
        int cell[3] = {0};
        for (int c = 0; c < dim; c++) cell[c] = (int)((body->point[c][p] - low[c]) / in->spacing);
        item[p] = item_at(cell[0], cell[1], cell[2], p);
    }
    number(sites, item, body->points, (int[]){0, 0, 0});
    memory_free(item);
}

struct solid_sites *solid_sites_new(const struct solid_input *in, const struct solid_body *b, long first, int reach) {
    struct solid_sites *sites = memory_new(MEMORY_SOLID, 1, sizeof *sites);
    sites->is_lattice = solid_shape_is_on_lattice(b);
    sites->first = first;
    sites->gap = INFINITY;
    switch (solid_shape_of(b)->places) {
    case SOLID_PLACES_LATTICE:
        if (b->voxels)
            cut_from_image(in, b, sites, reach);
        else
            cut_from_lattice(in, b, sites, reach);
        if (sites->count > 0) solid_bricks_number(sites);
        break;
    case SOLID_PLACES_CELLS:
        cut_from_plane(in, b, sites, reach);
        break;
    case SOLID_PLACES_POINTS:
        number_points(in, b, sites);
        break;
    }
    if (sites->count == 0)
        die_all(EXIT_CODE_SCENE, "solid body %s holds no particle at spacing %g m", b->name, in->spacing);
    return sites;
}

void solid_sites_free(struct solid_sites *sites) {
    if (!sites) return;
    if (!sites->map) memory_free(sites->bits);
    if (!sites->numbers) MEMORY_FREE(sites->start, sites->order);
    par_shared_free(sites->map);
    par_shared_free(sites->numbers);
    MEMORY_FREE(sites->point, sites->cell, sites->area, sites);
}

long solid_sites_id(const struct solid_sites *sites, const int site[3]) {
    int at[3];
    for (int c = 0; c < 3; c++) {
        at[c] = site[c];
        if (sites->wrap[c]) {
            const int r = (site[c] - sites->base[c]) % sites->wrap[c];
            at[c] = sites->base[c] + (r < 0 ? r + sites->wrap[c] : r);
        }
        at[c] -= sites->low[c];
        if (at[c] < 0 || at[c] >= (c == 0 ? SOLID_ROW : 1) * sites->rows[c]) return -1;
    }
    return solid_bricks_id(sites, at);
}

int solid_sites_in_period(const struct solid_input *in, const int wrap[3], int c, int site) {
    if (wrap[c] == 0) return site;
    const double first = -in->origin[c] / in->spacing - 0.5;
    while (site < first - SOLID_ON_SURFACE) site += wrap[c];
    while (site > first + wrap[c] + SOLID_ON_SURFACE) site -= wrap[c];
    return site;
}
