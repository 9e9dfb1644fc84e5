/* Lattice store of bonds: the box of lattice sites around a rank's particles, its rows, bond bits and weights. */
#include "solid/bonds/lattice.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/segments.h"

#include <string.h>

enum { NEEDED = -2, NOTHING = -1 };

static void site_of_cell(const struct solid_lattice *b, long cell, int site[3]) {
    site[0] = b->low[0] + (int)(cell % b->size[0]);
    site[1] = b->low[1] + (int)(cell / b->size[0] % b->size[1]);
    site[2] = b->low[2] + (int)(cell / b->size[0] / b->size[1]);
}

static void site_of_row(const struct solid_sites *t, int row, int site[3]) {
    site[0] = t->low[0] + SOLID_ROW * (row % t->rows[0]);
    site[1] = t->low[1] + row / t->rows[0] % t->rows[1];
    site[2] = t->low[2] + row / t->rows[0] / t->rows[1];
}

static int owned_row(const struct solid_sites *t, int row, long from, long to) {
    return t->start[row] >= from && t->start[row] < to;
}

static void offsets_new(struct solid_lattice *b) {
    b->offset = solid_store_array((size_t)b->stencil->n, sizeof *b->offset);
    for (int o = 0; o < b->stencil->n; o++) {
        const struct solid_offset *from = &b->stencil->offset[o];
        struct solid_lattice_offset *to = &b->offset[o];
        for (int c = 0; c < 3; c++) {
            to->xi[c] = from->xi[c];
            to->xi2[c] = 2 * from->xi[c];
        }
        to->inv_length2 = from->inv_length2;
        to->elastic = b->law.c0 * from->weight / (from->length * b->law.density);
        to->elastic_twice = 2 * to->elastic;
        to->viscous = from->weight * from->inv_length2 / b->law.density;
    }
}

/* The box of sites around the owned rows: one row wider along x, and wider by the family's reach along y and z. */
static void box_new(struct solid_lattice *b, const struct solid_sites *t, long from, long to) {
    int high[3] = {0};
    for (int q = 0; q < t->filled; q++) {
        if (!owned_row(t, t->order[q], from, to)) continue;
        int site[3];
        site_of_row(t, t->order[q], site);
        for (int c = 0; c < 3; c++) {
            if (b->rows == 0 || site[c] < b->low[c]) b->low[c] = site[c];
            if (b->rows == 0 || site[c] > high[c]) high[c] = site[c];
        }
        b->rows++;
    }
    if (b->rows == 0) return;
    b->sites = 1;
    for (int c = 0; c < 3; c++) {
        const int margin = c == 0 ? SOLID_ROW : b->stencil->reach;
        b->low[c] -= margin;
        b->size[c] = high[c] - b->low[c] + margin + (c == 0 ? SOLID_ROW : 1);
        if (c == 0)
            b->size[c] |= SOLID_ROW; /* an odd number of rows, so that lines of sites use different sets of the
                                      * cache */
        b->sites *= b->size[c];
    }
    ENSURE(b->sites < 2000000000L, "a dense box of %ld sites on one rank", b->sites);
    for (int o = 0; o < b->stencil->n; o++) {
        const int *step = b->stencil->offset[o].step;
        b->offset[o].shift = ((long)step[2] * b->size[1] + step[1]) * b->size[0] + step[0];
    }
}

static unsigned neighbours(const int *local, long cell) {
    unsigned bits = 0;
    for (int k = 0; k < SOLID_ROW; k++) bits |= (unsigned)(local[cell + k] != NOTHING) << k;
    return bits;
}

static void rows_new(struct solid_lattice *b, const struct solid_sites *t, long from, long to) {
    int r = 0, h = b->first;
    for (int q = 0; q < t->filled; q++) {
        const int row = t->order[q];
        if (!owned_row(t, row, from, to)) continue;
        int site[3];
        site_of_row(t, row, site);
        const int cell = ((site[2] - b->low[2]) * b->size[1] + site[1] - b->low[1]) * b->size[0] + site[0] - b->low[0];
        b->row_cell[r] = cell;
        b->row_first[r] = h;
        b->row_owned[r] = t->bits[row];
        b->row_of[cell / SOLID_ROW] = r;
        h += __builtin_popcount(t->bits[row]);
        r++;
    }
    b->n = h - b->first;
    b->cell = solid_store_array((size_t)b->n, sizeof *b->cell);
    for (r = 0, h = 0; r < b->rows; r++)
        for (int k = 0; k < SOLID_ROW; k++)
            if (b->row_owned[r] >> k & 1) b->cell[h++] = b->row_cell[r] + k;
}

/* Sets lambda of the whole families, and finds the sites that some owned particle needs. */
static void bonds_new(struct solid_lattice *b, const struct solid_sites *t) {
    for (long cell = 0; cell < b->sites; cell++) {
        int site[3];
        site_of_cell(b, cell, site);
        b->local[cell] = solid_sites_id(t, site) >= 0 ? 0 : NOTHING;
    }
    const int n = b->stencil->n;
    uint8_t *needed = solid_store_array((size_t)b->sites, 1);
    for (int r = 0; r < b->rows; r++) {
        solid_lattice_made(b, r, b->lambda + (size_t)r * (size_t)n);
        for (int k = 0; k < SOLID_ROW; k++) needed[b->row_cell[r] + k] |= b->row_owned[r] >> k & 1;
        for (int o = 0; o < n; o++)
            for (int k = 0; k < SOLID_ROW; k++)
                needed[b->row_cell[r] + b->offset[o].shift + k] |=
                    b->lambda[(size_t)r * (size_t)n + (size_t)o] >> k & 1;
    }
    for (long cell = 0; cell < b->sites; cell++) b->local[cell] = needed[cell] ? NEEDED : NOTHING;
    memory_free(needed);
}

static void active_new(struct solid_lattice *b) {
    const size_t n = (size_t)b->stencil->n;
    b->row_active = solid_store_array((size_t)b->rows, sizeof *b->row_active);
    for (int r = 0; r < b->rows; r++) {
        b->row_active[r + 1] = b->row_active[r];
        for (size_t o = 0; o < n; o++) b->row_active[r + 1] += b->lambda[(size_t)r * n + o] != 0;
    }
    b->active = solid_store_array((size_t)b->row_active[b->rows], sizeof *b->active);
    for (int r = 0; r < b->rows; r++) {
        long at = b->row_active[r];
        for (size_t o = 0; o < n; o++)
            if (b->lambda[(size_t)r * n + o]) b->active[at++] = (uint16_t)o;
    }
}

/* Indices of the rows in the field arrays. Rows that are adjacent on a line are adjacent in the arrays. Eight sites
 * that begin in a row that is not stored end in a stored one. */
static void places_new(struct solid_lattice *b) {
    const long rows = b->sites / SOLID_ROW;
    b->place = solid_store_array((size_t)rows, sizeof *b->place);
    b->places = SOLID_ROW;
    for (long r = 0; r < rows; r++) {
        if (neighbours(b->local, SOLID_ROW * r)) {
            b->place[r] = (int)b->places;
            b->places += SOLID_ROW;
        } else {
            b->place[r] = (int)b->places - SOLID_ROW; /* the last sites of such a row come before those of the next
                                                       * row */
        }
    }
}

/* The field arrays follow one another with a stride that gives each another offset within a page. With equal offsets,
 * values loaded and stored together would use the same sets of the cache, and a load would wait for the store at the
 * same offset. */
static void fields_new(struct solid_lattice *b) {
    enum { LINE = 8, PAGE = 64 * LINE, PLACE = 5 * LINE };
    size_t step = (size_t)b->places + 2 * SOLID_ROW;
    step += (PAGE + PLACE - step % PAGE) % PAGE;
    double *field = b->field = solid_store_array(10 * step, sizeof *field);
    double **const of[] = {&b->d[0], &b->d[1], &b->d[2], &b->w,    &b->f[0],
                           &b->f[1], &b->f[2], &b->v[0], &b->v[1], &b->v[2]};
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) *of[i] = field + i * step;
}

struct solid_lattice *solid_lattice_new(const struct solid_sites *t, const struct solid_stencil *stencil,
                                        struct solid_law law, long from, long to, int first) {
    struct solid_lattice *b = memory_new(MEMORY_SOLID, 1, sizeof *b);
    b->stencil = stencil;
    b->law = law;
    b->first = first;
    offsets_new(b);
    box_new(b, t, from, to);
    const size_t rows = (size_t)b->rows, sites = (size_t)b->sites;
    b->row_cell = solid_store_array(rows, sizeof *b->row_cell);
    b->row_first = solid_store_array(rows, sizeof *b->row_first);
    b->row_owned = solid_store_array(rows, 1);
    b->row_bulk = solid_store_array(rows, 1);
    b->lambda = solid_store_array(rows * (size_t)stencil->n, 1);
    b->row_of = solid_store_array(sites / SOLID_ROW, sizeof *b->row_of);
    memset(b->row_of, 0xff, (sites / SOLID_ROW) * sizeof *b->row_of);
    b->local = solid_store_array(sites, sizeof *b->local);
    rows_new(b, t, from, to);
    bonds_new(b, t);
    places_new(b);
    fields_new(b);
    active_new(b);
    return b;
}

void solid_lattice_free(struct solid_lattice *b) {
    if (!b) return;
    solid_segments_free(b->segments);
    void *owned[] = {b->row_active, b->active, b->row_cell, b->row_first, b->row_owned, b->row_bulk, b->lambda,
                     b->offset,     b->row_of, b->cell,     b->local,     b->field,     b->place,    b->copy_at,
                     b->copy_local, b};
    for (size_t i = 0; i < sizeof owned / sizeof owned[0]; i++) memory_free(owned[i]);
}

long solid_lattice_wanted(const struct solid_lattice *b, const struct solid_sites *t, long from, long to, long *id) {
    long wanted = 0;
    for (long cell = 0; cell < b->sites; cell++) {
        if (b->local[cell] != NEEDED) continue;
        int site[3];
        site_of_cell(b, cell, site);
        const long other = solid_sites_id(t, site);
        if (other >= from && other < to) continue;
        if (id) id[wanted] = other;
        wanted++;
    }
    return wanted;
}

void solid_lattice_link(struct solid_lattice *b, const struct solid_sites *t, const struct solid_numbering *numbering) {
    for (long cell = 0; cell < b->sites; cell++) b->copies += b->local[cell] == NEEDED;
    b->copy_at = solid_store_array((size_t)b->copies, sizeof *b->copy_at);
    b->copy_local = solid_store_array((size_t)b->copies, sizeof *b->copy_local);
    const int owned = (int)(numbering->to - numbering->from);
    int home = b->copies - b->n, image = home;
    for (long cell = 0; cell < b->sites; cell++) {
        if (b->local[cell] != NEEDED) continue;
        int site[3];
        site_of_cell(b, cell, site);
        const int h = b->local[cell] = solid_number_local(numbering, solid_sites_id(t, site));
        ENSURE(h >= 0, "site %d %d %d is not known here", site[0], site[1], site[2]);
        const int is_home = h >= b->first && h < b->first + b->n && b->cell[h - b->first] == cell;
        const int i = is_home ? home++ : h < owned ? --image : b->ghosts++;
        b->copy_at[i] = (int)solid_lattice_place(b, cell);
        b->copy_local[i] = h;
    }
    ENSURE(home == b->copies, "%d places for %d particles", home, b->n);
    ENSURE(image == b->ghosts, "%d places for %d ghosts", image, b->ghosts);
    b->away = b->copies - b->n;
    b->segments = solid_segments_new(b);
}

void solid_lattice_made(const struct solid_lattice *b, int row, uint8_t *lambda) {
    for (int o = 0; o < b->stencil->n; o++)
        lambda[o] = (uint8_t)(b->row_owned[row] & neighbours(b->local, b->row_cell[row] + b->offset[o].shift));
}

void solid_lattice_volumes(const struct solid_lattice *b, double *family_volume) {
    for (int i = 0; i < b->n; i++) {
        double sum = 0;
        for (int o = 0; o < b->stencil->n; o++)
            if (b->local[b->cell[i] + b->offset[o].shift] != NOTHING) sum += b->stencil->offset[o].weight;
        family_volume[b->first + i] = sum;
    }
}

void solid_lattice_weights(struct solid_lattice *b, const double *family_volume, int surface_correction) {
    for (long i = 0; i < b->places + SOLID_ROW; i++)
        b->w[i] = 1; /* also for sites without bonds, to avoid a division
                      * by 0 */
    for (int i = 0; i < b->copies; i++)
        if (surface_correction && family_volume[b->copy_local[i]] > 0)
            b->w[b->copy_at[i]] = family_volume[b->copy_local[i]] / b->stencil->full_volume;
    for (int r = 0; r < b->rows; r++) {
        b->row_bulk[r] = 1;
        for (int k = 0; k < SOLID_ROW; k++) {
            const int cell = b->row_cell[r] + k;
            if (!(b->row_owned[r] >> k & 1)) continue;
            if (*solid_lattice_w(b, cell) != 1) b->row_bulk[r] = 0;
            for (int o = 0; o < b->stencil->n; o++) {
                const long other = cell + b->offset[o].shift;
                if (b->local[other] != NOTHING && *solid_lattice_w(b, other) != 1) b->row_bulk[r] = 0;
            }
        }
    }
    solid_segments_weigh(b);
}

void solid_lattice_cut(struct solid_lattice *b, int h, int o) {
    const int cell = b->cell[h - b->first], r = b->row_of[cell / SOLID_ROW];
    b->lambda[(size_t)r * (size_t)b->stencil->n + (size_t)o] &= (uint8_t) ~(1u << cell % SOLID_ROW);
    solid_lattice_changed(b, h);
}

void solid_lattice_changed(struct solid_lattice *b, int h) { b->segments->stale[b->segments->of[h - b->first]] = 1; }

void solid_lattice_changed_all(struct solid_lattice *b) { memset(b->segments->stale, 1, (size_t)b->segments->n); }
