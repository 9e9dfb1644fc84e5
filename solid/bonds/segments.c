/* Orders a lattice's bonds into segments and strips for the force sweep, and packs segments again after bonds broke. */
#include "solid/bonds/segments.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/vec.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"

#include <math.h>

enum { NARROW = 4, COLUMNS = 7 };

/* Eight consecutive bits from any cell, of bits that are stored in rows of eight: of[row], with a stride in bytes. */
static unsigned bits_at(const struct solid_lattice *b, const uint8_t *of, size_t stride, long cell) {
    const int low = b->row_of[cell / SOLID_ROW], high = b->row_of[cell / SOLID_ROW + 1],
              shift = (int)(cell % SOLID_ROW);
    const unsigned first = low < 0 ? 0u : of[(size_t)low * stride], second = high < 0 ? 0u : of[(size_t)high * stride];
    return (first | second << SOLID_ROW) >> shift & 0xffu;
}

/* Takes the next window of bits. Returns the even number of its strip; lambda: the bits from the strip's first site. */
static int window(unsigned *bits, unsigned *lambda) {
    const int low = __builtin_ctz(*bits), high = 31 - __builtin_clz(*bits);
    if (high - low >= NARROW && VEC_IS_NATIVE) {
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

static void pack(const struct solid_lattice *b, const struct solid_segments *t, int g, struct packed *to) {
    const int offsets = b->stencil->n;
    const unsigned owned = t->owned[g];
    to->n = 0;
    for (int i = 0; i < offsets; i++) {
        const int o = t->order[i];
        unsigned bits = owned & bits_at(b, b->lambda + o, (size_t)offsets, t->cell[g]);
        if (!bits) continue;
        const unsigned home = bits_at(b, b->row_owned, 1, t->cell[g] + b->offset[o].shift);
        const uint32_t name = (uint32_t)o << 8;
        for (int alone = 0; alone < 2; alone++) {
            unsigned left = alone ? bits & ~home : o >= offsets / 2 ? bits & home : 0;
            while (left) {
                unsigned lambda;
                const int strip = window(&left, &lambda) + alone;
                to->strip[to->n] = (uint8_t)strip;
                to->far[to->n] =
                    (int)solid_lattice_place(b, t->cell[g] + solid_segments_strip_site(strip) + b->offset[o].shift);
                to->entry[to->n++] = name | lambda;
            }
        }
    }
}

static void place(const struct solid_lattice *b, struct solid_segments *t, int g) {
    struct packed p;
    long at[SOLID_STRIPS], end = t->first[g];
    pack(b, t, g, &p);
    ENSURE(p.n <= t->first[g + 1] - t->first[g], "segment %d: %d entries in the place of %ld", g, p.n,
           t->first[g + 1] - t->first[g]);
    for (int k = 0; k < SOLID_STRIPS; k++) t->count[g][k] = 0;
    for (int i = 0; i < p.n; i++) t->count[g][p.strip[i]]++;
    for (int k = 0; k < SOLID_STRIPS; k++) {
        at[k] = end;
        end += t->count[g][k];
    }
    for (int i = 0; i < p.n; i++) {
        t->far[at[p.strip[i]]] = p.far[i];
        t->entry[at[p.strip[i]]++] = p.entry[i];
    }
    t->stale[g] = 0;
}

void solid_segments_pack(const struct solid_lattice *b, int g) { place(b, b->segments, g); }

static int has_correction(const struct solid_lattice *b, const struct solid_segments *t, int g) {
    const uint32_t *entry = t->entry + t->first[g];
    for (int strip = 0; strip < SOLID_STRIPS; strip++)
        for (int i = 0; i < t->count[g][strip]; i++, entry++)
            for (int k = 0; k < SOLID_ROW; k++) {
                const long cell = t->cell[g] + solid_segments_strip_site(strip) + k;
                if ((*entry >> k & 1) &&
                    (*solid_lattice_w(b, cell) != 1 || *solid_lattice_w(b, cell + b->offset[*entry >> 8].shift) != 1))
                    return 1;
            }
    return 0;
}

void solid_segments_weigh(const struct solid_lattice *b) {
    for (int g = 0; g < b->segments->n; g++) b->segments->bulk[g] = !has_correction(b, b->segments, g);
}

/* Columns are steps along y and z. They are taken a few at a time, so that their lines stay in the first-level cache;
 * among them the x step varies slowest, so that consecutive entries touch different cache lines. */
static void order_new(const struct solid_lattice *b, struct solid_segments *t) {
    const struct solid_stencil *family = b->stencil;
    const int width = 2 * family->reach + 1;
    int n = 0;
    t->order = solid_store_array((size_t)family->n, sizeof *t->order);
    for (int first = 0; first < width * width; first += COLUMNS)
        for (int x = -family->reach; x <= family->reach; x++)
            for (int o = 0; o < family->n; o++) {
                const int *step = family->offset[o].step;
                const int column = (step[2] + family->reach) * width + step[1] + family->reach;
                if (step[0] == x && column >= first && column < first + COLUMNS) t->order[n++] = (uint16_t)o;
            }
}

/* Whether the particles (bits from the cell) have bonds to particles not owned here. */
static int reaches_away(const struct solid_lattice *b, long cell, unsigned particles) {
    const size_t offsets = (size_t)b->stencil->n;
    for (size_t o = 0; o < offsets; o++) {
        const unsigned bits = particles & bits_at(b, b->lambda + o, offsets, cell);
        if (bits & ~bits_at(b, b->row_owned, 1, cell + b->offset[o].shift)) return 1;
    }
    return 0;
}

/* Covers the lines of particles with segments; each segment begins at the first particle not yet covered. */
static void cover(const struct solid_lattice *b, struct solid_segments *t) {
    uint8_t *mine = solid_store_array((size_t)b->sites + SOLID_ROW, 1), *start = solid_store_array((size_t)b->sites, 1);
    for (int i = 0; i < b->n; i++) mine[b->cell[i]] = 1;
    for (long cell = 0; cell < b->sites; cell++) {
        if (!mine[cell]) continue;
        for (int k = 0; k < SOLID_ROW; k++) {
            start[cell] |= (uint8_t)(mine[cell + k] << k);
            mine[cell + k] = 0;
        }
        t->n++;
    }
    t->cell = solid_store_array((size_t)t->n, sizeof *t->cell);
    t->at = solid_store_array((size_t)t->n, sizeof *t->at);
    t->owned = solid_store_array((size_t)t->n, 1);
    for (int outer = 0, g = 0; outer < 2; outer++) {
        for (int r = 0; r < b->rows; r++)
            for (int k = 0; k < SOLID_ROW; k++) {
                const int cell = b->row_cell[r] + k;
                if (!start[cell] || reaches_away(b, cell, start[cell]) != outer) continue;
                t->cell[g] = cell;
                t->at[g] = (int)solid_lattice_place(b, cell);
                t->owned[g++] = start[cell];
            }
        if (!outer) t->inner = g;
    }
    memory_free(mine);
    memory_free(start);
}

struct solid_segments *solid_segments_new(const struct solid_lattice *b) {
    struct solid_segments *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    order_new(b, t);
    cover(b, t);
    const size_t n = (size_t)t->n;
    t->stale = solid_store_array(n, 1);
    t->large = solid_store_array(n, 1);
    t->bulk = solid_store_array(n, 1);
    t->high = solid_store_array(n, sizeof *t->high);
    t->first = solid_store_array(n, sizeof *t->first);
    t->count = solid_store_array(n, sizeof *t->count);
    t->of = solid_store_array((size_t)b->n, sizeof *t->of);
    struct packed p;
    for (int g = 0; g < t->n; g++) {
        t->large[g] = 1; /* not computed yet */
        t->high[g] = INFINITY;
        pack(b, t, g, &p);
        t->first[g + 1] = t->first[g] + p.n;
        for (int k = 0; k < SOLID_ROW; k++) {
            if (!(t->owned[g] >> k & 1)) continue;
            t->of[b->local[t->cell[g] + k] - b->first] = g;
        }
    }
    t->entry = solid_store_array((size_t)t->first[t->n], sizeof *t->entry);
    t->far = solid_store_array((size_t)t->first[t->n], sizeof *t->far);
    for (int g = 0; g < t->n; g++) place(b, t, g);
    return t;
}

void solid_segments_free(struct solid_segments *t) {
    if (!t) return;
    void *owned[] = {t->cell,  t->owned, t->stale, t->large, t->bulk, t->high, t->first,
                     t->entry, t->count, t->of,    t->order, t->at,   t->far,  t};
    for (size_t i = 0; i < sizeof owned / sizeof owned[0]; i++) memory_free(owned[i]);
}
