/* Lattice store of bonds: the box of lattice sites around a rank's particles, its rows, bond bits and weights. */
#include "solid/body/bricks.h"
#include "solid/bonds/lattice.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/segments.h"

#include <string.h>

enum { NEEDED = -2, NOTHING = -1 };

static void site_of_cell(const struct solid_lattice *lattice, long cell, int site[3]) {
    site[0] = lattice->low[0] + (int)(cell % lattice->size[0]);
    site[1] = lattice->low[1] + (int)(cell / lattice->size[0] % lattice->size[1]);
    site[2] = lattice->low[2] + (int)(cell / lattice->size[0] / lattice->size[1]);
}

static void offsets_new(struct solid_lattice *lattice) {
    lattice->offset = solid_store_array((size_t)lattice->stencil->n, sizeof *lattice->offset);
    for (int o = 0; o < lattice->stencil->n; o++) {
        const struct solid_offset *from = &lattice->stencil->offset[o];
        struct solid_lattice_offset *to = &lattice->offset[o];
        for (int c = 0; c < 3; c++) {
            to->xi[c] = from->xi[c];
            to->xi2[c] = 2 * from->xi[c];
        }
        to->inv_length2 = from->inv_length2;
        to->length2 = from->length * from->length;
        to->elastic = lattice->law.c0 * from->weight / (from->length * lattice->law.density);
        to->elastic_twice = 2 * to->elastic;
        to->viscous = from->weight * from->inv_length2 / lattice->law.density;
    }
}

/* The box of sites around the owned rows: one row wider along x, and wider by the family's reach along y and z. */
static void box_new(struct solid_lattice *lattice, const struct solid_sites *t, long from, long to) {
    int high[3] = {0};
    for (struct solid_bricks_walk row = {0}; solid_bricks_next(t, &row);) {
        if (row.id < from || row.id >= to) continue;
        for (int c = 0; c < 3; c++) {
            if (lattice->rows == 0 || row.site[c] < lattice->low[c]) lattice->low[c] = row.site[c];
            if (lattice->rows == 0 || row.site[c] > high[c]) high[c] = row.site[c];
        }
        lattice->rows++;
    }
    if (lattice->rows == 0) return;
    lattice->sites = 1;
    for (int c = 0; c < 3; c++) {
        const int margin = c == 0 ? SOLID_ROW : lattice->stencil->reach;
        lattice->low[c] -= margin;
        lattice->size[c] = high[c] - lattice->low[c] + margin + (c == 0 ? SOLID_ROW : 1);
        if (c == 0)
            lattice->size[c] |= SOLID_ROW; /* an odd number of rows, so that lines of sites use different sets of the
                                            * cache */
        lattice->sites *= lattice->size[c];
    }
    ENSURE(lattice->sites < 2000000000L, "a dense box of %ld sites on one rank", lattice->sites);
    for (int o = 0; o < lattice->stencil->n; o++) {
        const int *step = lattice->stencil->offset[o].step;
        lattice->offset[o].shift = ((long)step[2] * lattice->size[1] + step[1]) * lattice->size[0] + step[0];
    }
}

static unsigned neighbours(const int *local, long cell) {
    unsigned bits = 0;
    for (int k = 0; k < SOLID_ROW; k++) bits |= (unsigned)(local[cell + k] != NOTHING) << k;
    return bits;
}

static void rows_new(struct solid_lattice *lattice, const struct solid_sites *sites, long from, long to) {
    int r = 0, h = lattice->first;
    for (struct solid_bricks_walk row = {0}; solid_bricks_next(sites, &row);) {
        if (row.id < from || row.id >= to) continue;
        const int cell =
            ((row.site[2] - lattice->low[2]) * lattice->size[1] + row.site[1] - lattice->low[1]) * lattice->size[0] +
            row.site[0] - lattice->low[0];
        lattice->row_cell[r] = cell;
        lattice->row_first[r] = h;
        lattice->row_owned[r] = (uint8_t)row.bits;
        lattice->row_of[cell / SOLID_ROW] = r;
        h += __builtin_popcount(row.bits);
        r++;
    }
    lattice->n = h - lattice->first;
    lattice->cell = solid_store_array((size_t)lattice->n, sizeof *lattice->cell);
    for (r = 0, h = 0; r < lattice->rows; r++)
        for (int k = 0; k < SOLID_ROW; k++)
            if (lattice->row_owned[r] >> k & 1) lattice->cell[h++] = lattice->row_cell[r] + k;
}

/* Sets lambda of the whole families, and finds the sites that some owned particle needs. */
static void bonds_new(struct solid_lattice *lattice, const struct solid_sites *sites) {
    for (long cell = 0; cell < lattice->sites; cell++) {
        int site[3];
        site_of_cell(lattice, cell, site);
        lattice->local[cell] = solid_sites_id(sites, site) >= 0 ? 0 : NOTHING;
    }
    const int n = lattice->stencil->n;
    uint8_t *needed = solid_store_array((size_t)lattice->sites, 1);
    for (int r = 0; r < lattice->rows; r++) {
        solid_lattice_initial_bonds(lattice, r, lattice->lambda + (size_t)r * (size_t)n);
        for (int k = 0; k < SOLID_ROW; k++) needed[lattice->row_cell[r] + k] |= lattice->row_owned[r] >> k & 1;
        for (int o = 0; o < n; o++)
            for (int k = 0; k < SOLID_ROW; k++)
                needed[lattice->row_cell[r] + lattice->offset[o].shift + k] |=
                    lattice->lambda[(size_t)r * (size_t)n + (size_t)o] >> k & 1;
    }
    for (long cell = 0; cell < lattice->sites; cell++) lattice->local[cell] = needed[cell] ? NEEDED : NOTHING;
    memory_free(needed);
}

static void active_new(struct solid_lattice *lattice) {
    const size_t n = (size_t)lattice->stencil->n;
    lattice->row_active = solid_store_array((size_t)lattice->rows, sizeof *lattice->row_active);
    for (int r = 0; r < lattice->rows; r++) {
        lattice->row_active[r + 1] = lattice->row_active[r];
        for (size_t o = 0; o < n; o++) lattice->row_active[r + 1] += lattice->lambda[(size_t)r * n + o] != 0;
    }
    lattice->active = solid_store_array((size_t)lattice->row_active[lattice->rows], sizeof *lattice->active);
    for (int r = 0; r < lattice->rows; r++) {
        long at = lattice->row_active[r];
        for (size_t o = 0; o < n; o++)
            if (lattice->lambda[(size_t)r * n + o]) lattice->active[at++] = (uint16_t)o;
    }
}

/* Indices of the rows in the field arrays. Rows that are adjacent on a line are adjacent in the arrays. Eight sites
 * that begin in a row that is not stored end in a stored one. */
static void places_new(struct solid_lattice *lattice) {
    const long rows = lattice->sites / SOLID_ROW;
    lattice->place = solid_store_array((size_t)rows, sizeof *lattice->place);
    lattice->places = SOLID_ROW;
    for (long r = 0; r < rows; r++) {
        if (neighbours(lattice->local, SOLID_ROW * r)) {
            lattice->place[r] = (int)lattice->places;
            lattice->places += SOLID_ROW;
        } else {
            lattice->place[r] = (int)lattice->places - SOLID_ROW; /* the last sites of such a row come before those of
                                                                   * the next row */
        }
    }
}

void solid_lattice_pressure_new(struct solid_lattice *lattice) {
    const size_t n = (size_t)lattice->places + SOLID_ROW;
    if (lattice->w_single)
        lattice->pressure_single = solid_store_array(n, sizeof *lattice->pressure_single);
    else
        lattice->pressure = solid_store_array(n, sizeof *lattice->pressure);
}

void solid_lattice_pressure_set(const struct solid_lattice *lattice, int from, int to, const double *pressure) {
    for (int i = from; i < to; i++) {
        const double p = pressure[lattice->copy_local[i]];
        if (lattice->w_single)
            lattice->pressure_single[lattice->copy_at[i]] = (float)p;
        else
            lattice->pressure[lattice->copy_at[i]] = p;
    }
}

/* From one field array to the next, in doubles, for elements of `size` bytes. It gives each array another offset within
 * a page. With equal offsets, values loaded and stored together would use the same sets of the cache, and a load would
 * wait for the store at the same offset. */
static size_t step_of(const struct solid_lattice *lattice, size_t size) {
    enum { LINE = 64, PAGE = 64 * LINE, PLACE = 7 * LINE };
    const size_t step = ((size_t)lattice->places + 2 * SOLID_ROW) * size;
    return (step + (PAGE + PLACE - step % PAGE) % PAGE) / sizeof(double);
}

static void fields_new(struct solid_lattice *lattice, int single) {
    double **const arrays[] = {&lattice->d[0], &lattice->d[1], &lattice->d[2], &lattice->w,    &lattice->f[0],
                               &lattice->f[1], &lattice->f[2], &lattice->v[0], &lattice->v[1], &lattice->v[2]};
    float **const singles[] = {&lattice->d_single[0], &lattice->d_single[1], &lattice->d_single[2],
                               &lattice->w_single,    &lattice->f_single[0], &lattice->f_single[1],
                               &lattice->f_single[2], &lattice->v_single[0], &lattice->v_single[1],
                               &lattice->v_single[2]};
    const size_t doubles = single ? 4 : sizeof arrays / sizeof arrays[0],
                 floats = single ? sizeof singles / sizeof singles[0] : 0, step = step_of(lattice, sizeof(double)),
                 half = step_of(lattice, sizeof(float));
    double *field = lattice->field = solid_store_array(doubles * step + floats * half, sizeof *field);
    for (size_t i = 0; i < doubles; i++, field += step) *arrays[i] = field;
    for (size_t i = 0; i < floats; i++, field += half) *singles[i] = (float *)field;
}

struct solid_lattice *solid_lattice_new(const struct solid_sites *t, const struct solid_stencil *stencil,
                                        struct solid_law law, long from, long to, int first, int rigid, int single) {
    struct solid_lattice *lattice = memory_new(MEMORY_SOLID, 1, sizeof *lattice);
    lattice->stencil = stencil;
    lattice->law = law;
    lattice->first = first;
    offsets_new(lattice);
    box_new(lattice, t, from, to);
    const size_t rows = (size_t)lattice->rows, sites = (size_t)lattice->sites;
    lattice->row_cell = solid_store_array(rows, sizeof *lattice->row_cell);
    lattice->row_first = solid_store_array(rows, sizeof *lattice->row_first);
    lattice->row_owned = solid_store_array(rows, 1);
    lattice->row_bulk = solid_store_array(rows, 1);
    lattice->lambda = solid_store_array(rows * (size_t)stencil->n, 1);
    lattice->row_version = solid_store_array(rows, sizeof *lattice->row_version);
    if (law.s_c > 0) lattice->soft = solid_store_array(rows * (size_t)stencil->n, 1);
    lattice->row_of = solid_store_array(sites / SOLID_ROW, sizeof *lattice->row_of);
    memset(lattice->row_of, 0xff, (sites / SOLID_ROW) * sizeof *lattice->row_of);
    lattice->local = solid_store_array(sites, sizeof *lattice->local);
    rows_new(lattice, t, from, to);
    bonds_new(lattice, t);
    places_new(lattice);
    if (rigid)
        lattice->w = lattice->field = solid_store_array((size_t)lattice->places + SOLID_ROW, sizeof *lattice->field);
    else
        fields_new(lattice, single);
    active_new(lattice);
    return lattice;
}

void solid_lattice_free(struct solid_lattice *lattice) {
    if (!lattice) return;
    solid_segments_free(lattice->segments);
    solid_materials_free(lattice->materials);
    MEMORY_FREE(lattice->row_active, lattice->active, lattice->row_cell, lattice->row_first, lattice->row_owned,
                lattice->row_bulk, lattice->row_version, lattice->lambda, lattice->offset, lattice->row_of,
                lattice->cell, lattice->local, lattice->field, lattice->place, lattice->copy_at, lattice->copy_local,
                lattice->soft, lattice->pressure, lattice->pressure_single, lattice);
}

long solid_lattice_wanted(const struct solid_lattice *lattice, const struct solid_sites *sites, long from, long to,
                          long *id) {
    long wanted = 0;
    for (long cell = 0; cell < lattice->sites; cell++) {
        if (lattice->local[cell] != NEEDED) continue;
        int site[3];
        site_of_cell(lattice, cell, site);
        const long other = solid_sites_id(sites, site);
        if (other >= from && other < to) continue;
        if (id) id[wanted] = other;
        wanted++;
    }
    return wanted;
}

void solid_lattice_link(struct solid_lattice *lattice, const struct solid_sites *sites,
                        const struct solid_numbering *numbering) {
    for (long cell = 0; cell < lattice->sites; cell++) lattice->copies += lattice->local[cell] == NEEDED;
    lattice->copy_at = solid_store_array((size_t)lattice->copies, sizeof *lattice->copy_at);
    lattice->copy_local = solid_store_array((size_t)lattice->copies, sizeof *lattice->copy_local);
    const int owned = (int)(numbering->to - numbering->from);
    int own_place = lattice->copies - lattice->n, image = own_place;
    for (long cell = 0; cell < lattice->sites; cell++) {
        if (lattice->local[cell] != NEEDED) continue;
        int site[3];
        site_of_cell(lattice, cell, site);
        const int h = lattice->local[cell] = solid_number_local(numbering, solid_sites_id(sites, site));
        ENSURE(h >= 0, "site %d %d %d is not known here", site[0], site[1], site[2]);
        const int is_own =
            h >= lattice->first && h < lattice->first + lattice->n && lattice->cell[h - lattice->first] == cell;
        const int i = is_own ? own_place++ : h < owned ? --image : lattice->ghosts++;
        lattice->copy_at[i] = (int)solid_lattice_place(lattice, cell);
        lattice->copy_local[i] = h;
    }
    ENSURE(own_place == lattice->copies, "%d places for %d particles", own_place, lattice->n);
    ENSURE(image == lattice->ghosts, "%d places for %d ghosts", image, lattice->ghosts);
    lattice->away = lattice->copies - lattice->n;
    if (lattice->d[0]) lattice->segments = solid_segments_new(lattice);
}

void solid_lattice_initial_bonds(const struct solid_lattice *lattice, int row, uint8_t *lambda) {
    for (int o = 0; o < lattice->stencil->n; o++)
        lambda[o] = (uint8_t)(lattice->row_owned[row] &
                              neighbours(lattice->local, lattice->row_cell[row] + lattice->offset[o].shift));
}

void solid_lattice_volumes(const struct solid_lattice *lattice, double *family_volume) {
    for (int i = 0; i < lattice->n; i++) {
        double sum = 0;
        for (int o = 0; o < lattice->stencil->n; o++)
            if (lattice->local[lattice->cell[i] + lattice->offset[o].shift] != NOTHING)
                sum += lattice->stencil->offset[o].weight;
        family_volume[lattice->first + i] = sum;
    }
}

void solid_lattice_weights(struct solid_lattice *lattice, const double *w) {
    for (long i = 0; i < lattice->places + SOLID_ROW; i++)
        lattice->w[i] = 1; /* also for sites without bonds, to avoid a division
                            * by 0 */
    for (int i = 0; i < lattice->copies; i++) lattice->w[lattice->copy_at[i]] = w[lattice->copy_local[i]];
    for (long i = 0; lattice->w_single && i < lattice->places + SOLID_ROW; i++)
        lattice->w_single[i] = (float)lattice->w[i];
    for (int r = 0; r < lattice->rows; r++) {
        lattice->row_bulk[r] = 1;
        for (int k = 0; k < SOLID_ROW; k++) {
            const int cell = lattice->row_cell[r] + k;
            if (!(lattice->row_owned[r] >> k & 1)) continue;
            if (*solid_lattice_w(lattice, cell) != 1) lattice->row_bulk[r] = 0;
            for (int o = 0; o < lattice->stencil->n; o++) {
                const long other = cell + lattice->offset[o].shift;
                if (lattice->local[other] != NOTHING && *solid_lattice_w(lattice, other) != 1) lattice->row_bulk[r] = 0;
            }
        }
    }
    if (lattice->segments) solid_segments_weigh(lattice);
}

void solid_lattice_cut(struct solid_lattice *lattice, int h, int o) {
    const int cell = lattice->cell[h - lattice->first], r = lattice->row_of[cell / SOLID_ROW];
    lattice->lambda[(size_t)r * (size_t)lattice->stencil->n + (size_t)o] &= (uint8_t) ~(1u << cell % SOLID_ROW);
    solid_lattice_changed(lattice, h);
}

void solid_lattice_soften(struct solid_lattice *lattice, int h, int o, int softens) {
    const int cell = lattice->cell[h - lattice->first], r = lattice->row_of[cell / SOLID_ROW];
    uint8_t *soft = lattice->soft + (size_t)r * (size_t)lattice->stencil->n + (size_t)o;
    *soft = (uint8_t)((*soft & ~(1u << cell % SOLID_ROW)) | (unsigned)softens << cell % SOLID_ROW);
    solid_lattice_changed(lattice, h);
}

void solid_lattice_changed(struct solid_lattice *b, int h) {
    b->row_version[b->row_of[b->cell[h - b->first] / SOLID_ROW]]++;
    if (b->segments) b->segments->stale[b->segments->segment_of[h - b->first]] = 1;
}

void solid_lattice_changed_all(struct solid_lattice *b) {
    for (int r = 0; r < b->rows; r++) b->row_version[r]++;
    if (b->segments) memset(b->segments->stale, 1, (size_t)b->segments->n);
}
