/* Orders a lattice's bonds into segments and strips for the force sweep, and packs segments again after bonds broke. */
#include "solid/bonds/segments.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"

#include <math.h>

enum { NARROW = 4, COLUMNS = 49, LINES = 16 };

/* Eight consecutive bits from any cell, of bits that are stored in rows of eight: bits[row], with a stride in bytes. */
static unsigned bits_at(const struct solid_lattice *lattice, const uint8_t *bits, size_t stride, long cell) {
    const int low = lattice->row_of[cell / SOLID_ROW], high = lattice->row_of[cell / SOLID_ROW + 1],
              shift = (int)(cell % SOLID_ROW);
    const unsigned first = low < 0 ? 0u : bits[(size_t)low * stride],
                   second = high < 0 ? 0u : bits[(size_t)high * stride];
    return (first | second << SOLID_ROW) >> shift & 0xffu;
}

/* Takes the next window of bits. Returns the even number of its strip; lambda: the bits from the strip's first site. */
static int window(unsigned *bits, unsigned *lambda) {
    const int low = __builtin_ctz(*bits), high = 31 - __builtin_clz(*bits);
    if (high - low >= NARROW && SOLID_STRIPS_WIDE) {
        *lambda = *bits;
        *bits = 0;
        return 0;
    }
    /* site 0, 4 or 2 if possible, which gives fewer strips */
    const int site = low >= 4 ? 4 : high < 4 ? 0 : low >= 2 && high < 6 ? 2 : low;
    *lambda = *bits >> site & 0xfu;
    *bits &= ~(0xfu << site);
    return 2 + 2 * site;
}

struct packed {
    int n;
    uint8_t strip[4 * SOLID_FAMILY_MAX];
    uint32_t entry[4 * SOLID_FAMILY_MAX];
    int far[4 * SOLID_FAMILY_MAX];
};

static void pack(const struct solid_lattice *lattice, const struct solid_segments *segments, int g, struct packed *to) {
    const int offsets = lattice->stencil->n;
    const unsigned owned = segments->owned[g];
    to->n = 0;
    for (int i = 0; i < offsets; i++) {
        const int o = segments->order[i];
        unsigned bits = owned & bits_at(lattice, lattice->lambda + o, (size_t)offsets, segments->cell[g]);
        if (lattice->soft && !lattice->is_whole)
            bits &= ~bits_at(lattice, lattice->soft + o, (size_t)offsets, segments->cell[g]);
        if (!bits) continue;
        const unsigned own_far = bits_at(lattice, lattice->row_owned, 1, segments->cell[g] + lattice->offset[o].shift);
        const uint32_t name = (uint32_t)o << 8;
        for (int alone = 0; alone < 2; alone++) {
            unsigned left = alone ? bits & ~own_far : o >= offsets / 2 ? bits & own_far : 0;
            while (left) {
                unsigned lambda;
                const int strip = window(&left, &lambda) + alone;
                to->strip[to->n] = (uint8_t)strip;
                to->far[to->n] = (int)solid_lattice_place(
                    lattice, segments->cell[g] + solid_segments_strip_site(strip) + lattice->offset[o].shift);
                to->entry[to->n++] = name | lambda;
            }
        }
    }
}

static void place(const struct solid_lattice *lattice, struct solid_segments *segments, int g) {
    struct packed p;
    long at[SOLID_STRIPS], end = segments->first[g];
    pack(lattice, segments, g, &p);
    ENSURE(p.n <= segments->first[g + 1] - segments->first[g], "segment %d: %d entries in the place of %ld", g, p.n,
           segments->first[g + 1] - segments->first[g]);
    for (int k = 0; k < SOLID_STRIPS; k++) segments->count[g][k] = 0;
    for (int i = 0; i < p.n; i++) segments->count[g][p.strip[i]]++;
    for (int k = 0; k < SOLID_STRIPS; k++) {
        at[k] = end;
        end += segments->count[g][k];
    }
    for (int i = 0; i < p.n; i++) {
        segments->far[at[p.strip[i]]] = p.far[i];
        segments->entry[at[p.strip[i]]++] = p.entry[i];
    }
    segments->stale[g] = 0;
}

void solid_segments_pack(const struct solid_lattice *b, int g) { place(b, b->segments, g); }

static int has_correction(const struct solid_lattice *lattice, const struct solid_segments *segments, int g) {
    const uint32_t *entry = segments->entry + segments->first[g];
    for (int strip = 0; strip < SOLID_STRIPS; strip++)
        for (int i = 0; i < segments->count[g][strip]; i++, entry++)
            for (int k = 0; k < SOLID_ROW; k++) {
                const long cell = segments->cell[g] + solid_segments_strip_site(strip) + k;
                if ((*entry >> k & 1) && (*solid_lattice_w(lattice, cell) != 1 ||
                                          *solid_lattice_w(lattice, cell + lattice->offset[*entry >> 8].shift) != 1))
                    return 1;
            }
    return 0;
}

void solid_segments_weigh(const struct solid_lattice *lattice) {
    for (int g = 0; g < lattice->segments->n; g++)
        lattice->segments->bulk[g] = !has_correction(lattice, lattice->segments, g);
}

/* Columns are steps along y and z. Among them the x step varies slowest, so that entries whose other ends overlap
 * but for one site are far from each other: a load that overlaps a store must wait until the store is in the cache.
 * With long horizons a few columns at a time are taken, so that their lines stay in the first-level cache. */
static void order_new(const struct solid_lattice *lattice, struct solid_segments *segments) {
    const struct solid_stencil *family = lattice->stencil;
    const int width = 2 * family->reach + 1;
    int n = 0;
    segments->order = solid_store_array((size_t)family->n, sizeof *segments->order);
    for (int first = 0; first < width * width; first += COLUMNS)
        for (int x = -family->reach; x <= family->reach; x++)
            for (int o = 0; o < family->n; o++) {
                const int *step = family->offset[o].step;
                const int column = (step[2] + family->reach) * width + step[1] + family->reach;
                if (step[0] == x && column >= first && column < first + COLUMNS) segments->order[n++] = (uint16_t)o;
            }
}

/* Whether the particles (bits from the cell) have bonds to particles not owned here. */
static int reaches_away(const struct solid_lattice *lattice, long cell, unsigned particles) {
    const size_t offsets = (size_t)lattice->stencil->n;
    for (size_t o = 0; o < offsets; o++) {
        const unsigned bits = particles & bits_at(lattice, lattice->lambda + o, offsets, cell);
        if (bits & ~bits_at(lattice, lattice->row_owned, 1, cell + lattice->offset[o].shift)) return 1;
    }
    return 0;
}

/* Adds those segments of a line along x that reach away from this rank's particles (outer), or do not, from number g
 * on. start: bits of the particles of the segment that begins at a cell, 0: none does. Returns the next number. */
static int add_line(const struct solid_lattice *lattice, const uint8_t *start, int line, int outer,
                    struct solid_segments *segments, int g) {
    for (int cell = line * lattice->size[0]; cell < (line + 1) * lattice->size[0]; cell++) {
        if (!start[cell] || reaches_away(lattice, cell, start[cell]) != outer) continue;
        segments->cell[g] = cell;
        segments->at[g] = (int)solid_lattice_place(lattice, cell);
        segments->owned[g++] = start[cell];
    }
    return g;
}

/* Covers the lines of particles with segments; each segment begins at the first particle not yet covered. The segments
 * of a few lines follow each other layer by layer, so that the layers that their bonds reach stay in the second-level
 * cache. */
static void cover(const struct solid_lattice *lattice, struct solid_segments *segments) {
    const int *size = lattice->size;
    uint8_t *uncovered = solid_store_array((size_t)lattice->sites + SOLID_ROW, 1),
            *start = solid_store_array((size_t)lattice->sites, 1);
    for (int i = 0; i < lattice->n; i++) uncovered[lattice->cell[i]] = 1;
    for (long cell = 0; cell < lattice->sites; cell++) {
        if (!uncovered[cell]) continue;
        for (int k = 0; k < SOLID_ROW; k++) {
            start[cell] |= (uint8_t)(uncovered[cell + k] << k);
            uncovered[cell + k] = 0;
        }
        segments->n++;
    }
    segments->cell = solid_store_array((size_t)segments->n, sizeof *segments->cell);
    segments->at = solid_store_array((size_t)segments->n, sizeof *segments->at);
    segments->owned = solid_store_array((size_t)segments->n, 1);
    for (int outer = 0, g = 0; outer < 2; outer++) {
        for (int from = 0; from < size[1]; from += LINES)
            for (int z = 0; z < size[2]; z++)
                for (int y = from; y < from + LINES && y < size[1]; y++)
                    g = add_line(lattice, start, z * size[1] + y, outer, segments, g);
        if (!outer) segments->inner = g;
    }
    MEMORY_FREE(uncovered, start);
}

static void forget(const struct solid_lattice *lattice, struct solid_segments *segments) {
    for (int g = 0; g < segments->n; g++) {
        segments->large[g] = !lattice->w_single; /* in double the kernel with square roots is right for any eps */
        segments->high[g] = INFINITY;
    }
}

void solid_segments_reset(const struct solid_lattice *lattice) { forget(lattice, lattice->segments); }

struct solid_segments *solid_segments_new(const struct solid_lattice *lattice) {
    struct solid_segments *segments = memory_new(MEMORY_SOLID, 1, sizeof *segments);
    order_new(lattice, segments);
    cover(lattice, segments);
    const size_t n = (size_t)segments->n;
    segments->stale = solid_store_array(n, 1);
    segments->large = solid_store_array(n, 1);
    segments->bulk = solid_store_array(n, 1);
    segments->high = solid_store_array(n, sizeof *segments->high);
    segments->first = solid_store_array(n, sizeof *segments->first);
    segments->count = solid_store_array(n, sizeof *segments->count);
    segments->segment_of = solid_store_array((size_t)lattice->n, sizeof *segments->segment_of);
    struct packed p;
    forget(lattice, segments);
    for (int g = 0; g < segments->n; g++) {
        pack(lattice, segments, g, &p);
        segments->first[g + 1] = segments->first[g] + p.n;
        for (int k = 0; k < SOLID_ROW; k++) {
            if (!(segments->owned[g] >> k & 1)) continue;
            segments->segment_of[lattice->local[segments->cell[g] + k] - lattice->first] = g;
        }
    }
    segments->entry = solid_store_array((size_t)segments->first[segments->n], sizeof *segments->entry);
    segments->far = solid_store_array((size_t)segments->first[segments->n], sizeof *segments->far);
    for (int g = 0; g < segments->n; g++) place(lattice, segments, g);
    segments->slabs[0] = solid_slabs_new(lattice, segments, 0, segments->inner);
    segments->slabs[1] = solid_slabs_new(lattice, segments, segments->inner, segments->n);
    return segments;
}

void solid_segments_free(struct solid_segments *segments) {
    if (!segments) return;
    for (int others = 0; others < 2; others++) solid_slabs_free(&segments->slabs[others]);
    MEMORY_FREE(segments->cell, segments->owned, segments->stale, segments->large, segments->bulk, segments->high,
                segments->first, segments->entry, segments->count, segments->segment_of, segments->order, segments->at,
                segments->far, segments);
}
