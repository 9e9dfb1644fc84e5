/* Finds the fragments: connected components of intact bonds over all ranks, with mass, centre and velocity. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/sets.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/vec.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"
#include "solid/bonds/soft.h"
#include "solid/measure/fragments.h"

#include <limits.h>
#include <stdlib.h>

/* Particles that are connected by intact bonds, among those on this rank, owned or ghost, are disjoint sets
 * (base/sets.h); parent: of each particle. */

/* Joins a row's particles with their neighbours at offset o. piece [sites]: the root of the site's particle, possibly
 * out of date; only particles with different roots are joined. */
static inline void join_at(const struct solid_lattice *lattice, int cell, int o, unsigned intact, int *piece,
                           int *parent) {
    const long at = cell + lattice->offset[o].shift;
    for (unsigned lanes = intact & vec_differ(piece + cell, piece + at); lanes; lanes &= lanes - 1) {
        const int k = __builtin_ctz(lanes);
        piece[cell + k] = piece[at + k] = sets_join_int(parent, lattice->local[cell + k], lattice->local[at + k]);
    }
}

/* Joins the particles of all bonds of a segment (solid/bonds/segments.h): bonds between owned particles from one end,
 * others from this end. */
static void join_segment(const struct solid_lattice *lattice, int g, int *piece, int *parent) {
    const struct solid_segments *all = lattice->segments;
    if (all->stale[g]) solid_segments_pack(lattice, g);
    const uint32_t *entry = all->entry + all->first[g];
    for (int strip = 0; strip < SOLID_STRIPS; strip++)
        for (int i = 0; i < all->count[g][strip]; i++, entry++)
            join_at(lattice, all->cell[g] + solid_segments_strip_site(strip), (int)(*entry >> 8), *entry & 0xffu, piece,
                    parent);
}

/* The smallest and largest piece of the particles in each eight sites of the box; without a particle INT_MAX, -1. */
struct span {
    int *low, *high; /* [sites/8] */
};

static struct span span_new(long n) {
    return (struct span){memory_new(MEMORY_SOLID, (size_t)n, sizeof(int)),
                         memory_new(MEMORY_SOLID, (size_t)n, sizeof(int))};
}

static void span_free(const struct span *s) { MEMORY_FREE(s->low, s->high); }

static struct span span_of(const struct solid_lattice *lattice, const int *piece) {
    const struct span s = span_new(lattice->sites / SOLID_ROW);
    for (long r = 0; r < lattice->sites / SOLID_ROW; r++) {
        int low = INT_MAX, high = -1;
        for (int k = 0; k < SOLID_ROW; k++) {
            const int is = piece[r * SOLID_ROW + k];
            low = is >= 0 && is < low ? is : low;
            high = is > high ? is : high;
        }
        s.low[r] = low;
        s.high[r] = high;
    }
    return s;
}

/* Widens each span to `reach` lines of n spans on both sides, in each of `planes` planes of `lines` lines. */
static void span_widen(struct span *s, int planes, int lines, int n, int reach) {
    const struct span to = span_new((long)planes * lines * n);
    for (int k = 0; k < planes; k++)
        for (int j = 0; j < lines; j++) {
            const long at = ((long)k * lines + j) * n;
            int *restrict low = to.low + at, *restrict high = to.high + at;
            for (int i = 0; i < n; i++) low[i] = INT_MAX, high[i] = -1;
            for (int l = j < reach ? 0 : j - reach; l < lines && l <= j + reach; l++) {
                const long from = ((long)k * lines + l) * n;
                for (int i = 0; i < n; i++) {
                    low[i] = s->low[from + i] < low[i] ? s->low[from + i] : low[i];
                    high[i] = s->high[from + i] > high[i] ? s->high[from + i] : high[i];
                }
            }
        }
    span_free(s);
    *s = to;
}

/* 1: all particles at or within reach of the eight sites from `cell` on are of one piece, by the widened spans. */
static int is_within(const struct span *s, long cell, int reach) {
    int low = INT_MAX, high = -1;
    for (long r = (cell - reach) / SOLID_ROW; r <= (cell + SOLID_ROW - 1 + reach) / SOLID_ROW; r++) {
        low = s->low[r] < low ? s->low[r] : low;
        high = s->high[r] > high ? s->high[r] : high;
    }
    return low >= high;
}

/* Nearest neighbours are joined first. Most of a body is then connected, and where all particles within reach belong
 * to one piece no bond is tested; few of the other bonds need work. */
static void join_lattice(const struct solid_lattice *lattice, int *parent) {
    int *piece = memory_new(MEMORY_SOLID, (size_t)lattice->sites + 2 * SOLID_ROW, sizeof *piece);
    const int offsets = lattice->stencil->n, reach = lattice->stencil->reach, *size = lattice->size;
    for (long i = 0; i < lattice->sites; i++) piece[i] = lattice->local[i];
    for (int o = offsets / 2; o < offsets; o++) { /* from one end of a bond; from a ghost's only below */
        if (lattice->stencil->offset[o].length > 1.1 * lattice->stencil->spacing) continue;
        for (int r = 0; r < lattice->rows; r++)
            join_at(lattice, lattice->row_cell[r], o, lattice->lambda[(size_t)r * (size_t)offsets + (size_t)o], piece,
                    parent);
    }
    for (long i = 0; i < lattice->sites; i++)
        piece[i] = lattice->local[i] < 0 ? -1 : sets_root_int(parent, lattice->local[i]);
    struct span near = span_of(lattice, piece);
    span_widen(&near, size[2], size[1], size[0] / SOLID_ROW, reach);
    span_widen(&near, 1, size[2], size[1] * (size[0] / SOLID_ROW), reach);
    for (int g = 0; g < lattice->segments->n; g++)
        if (!is_within(&near, lattice->segments->cell[g], reach)) join_segment(lattice, g, piece, parent);
    span_free(&near);
    memory_free(piece);
}

static void join_list(const struct solid_list *list, int *parent) {
    for (int i = 0; i < list->n; i++)
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const int l = solid_list_other(list, j);
            if (solid_list_is_intact(list, j) && parent[list->first + i] != parent[l])
                sets_join_int(parent, list->first + i, l);
        }
}

/* Bonds that soften are intact, and no part of a lattice's segments. */
static void join_soft(const struct solid_soft *soft, int *parent) {
    for (int i = 0; i < soft->n; i++)
        if (parent[soft->bond[i].h] != parent[soft->bond[i].l]) sets_join_int(parent, soft->bond[i].h, soft->bond[i].l);
}

/* parent [n + n_ghost], every particle's root. */
static void pieces(const struct solid *s, int *parent) {
    const int n = s->n + s->n_ghost;
    for (int h = 0; h < n; h++) parent[h] = h;
    for (int b = 0; b < s->family->bodies; b++) {
        if (s->family->lattice[b])
            join_lattice(s->family->lattice[b], parent);
        else
            join_list(s->family->list[b], parent);
    }
    if (s->soft) join_soft(s->soft, parent);
    for (int h = 0; h < n; h++) parent[h] = sets_root_int(parent, h);
}

/* Finds the smallest global id of each fragment, in label[n + n_ghost]. A component on this rank takes the smallest
 * label that one of its ghosts has on its owner, until no rank finds a smaller one. Components that hold ghosts only
 * are ignored. */
static void spread(struct solid *s, const int *parent, double *label) {
    const long from = s->first[par_rank()];
    const int n = s->n + s->n_ghost;
    for (int h = 0; h < s->n; h++)
        label[h] = (double)(from + parent[h]); /* the id of the root, which is owned as
                                                * well */
    for (long changed = 1; changed;) {
        changed = 0;
        par_ghost_update(s->ghost, 1, &label, s->n);
        for (int g = s->n; g < n; g++) {
            const int root = parent[g];
            if (root >= s->n || !(label[g] < label[root])) continue;
            label[root] = label[g];
            changed = 1;
        }
        for (int h = 0; changed && h < s->n; h++) label[h] = label[parent[h]];
        changed = par_sum_long(changed);
    }
}

static int by_id(const void *a, const void *b) {
    const struct solid_fragment *p = a, *q = b;
    return (p->id > q->id) - (p->id < q->id);
}

static int by_size(const void *a, const void *b) {
    const struct solid_fragment *p = a, *q = b;
    return p->particles != q->particles ? (p->particles < q->particles ? 1 : -1) : by_id(a, b);
}

/* Adds up consecutive entries with the same id in a sorted list. Returns the number of entries left. x and v hold
 * sums. */
static int merge(struct solid_fragment *list, int n) {
    int m = 0;
    for (int i = 0; i < n; i++) {
        if (m > 0 && list[m - 1].id == list[i].id) {
            struct solid_fragment *to = &list[m - 1];
            to->particles += list[i].particles;
            to->mass += list[i].mass;
            to->held |= list[i].held;
            for (int c = 0; c < 3; c++) {
                to->x[c] += list[i].x[c];
                to->v[c] += list[i].v[c];
            }
        } else {
            list[m++] = list[i];
        }
    }
    return m;
}

/* This rank's parts of fragments, sums of mass, m x, m v, sorted by id; x = X0 + d, not wrapped into the periods. */
static struct solid_fragment *parts(const struct solid *s, const double *label, int *n) {
    struct solid_fragment *list = calloc((size_t)s->n + 1, sizeof *list);
    ENSURE(list, "no memory for %d fragments", s->n);
    int m = 0;
    long last = -1;
    for (int h = 0; h < s->n; h++) {
        const long id = (long)label[h];
        if (m == 0 || id != last) list[m++].id = id;
        last = id;
        struct solid_fragment *f = &list[m - 1];
        const double mass = solid_density(s, h) * s->volume[h];
        f->particles++;
        f->mass += mass;
        f->held |= (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) != 0;
        for (int c = 0; c < s->dim; c++) {
            f->x[c] += mass * (s->x0[c][h] + s->d[c][h]);
            f->v[c] += mass * s->v[c][h];
        }
    }
    qsort(list, (size_t)m, sizeof *list, by_id);
    *n = merge(list, m);
    return list;
}

int solid_fragments_measure(struct solid *s, long *id, struct solid_fragment **out) {
    const size_t all = (size_t)(s->n + s->n_ghost) + 1;
    int *parent = memory_new(MEMORY_SOLID, all, sizeof *parent);
    double *label = memory_new(MEMORY_SOLID, all, sizeof *label);
    pieces(s, parent);
    spread(s, parent, label);
    memory_free(parent);
    if (id)
        for (int h = 0; h < s->n; h++) id[h] = (long)label[h];

    int pieces = 0;
    struct solid_fragment *part = parts(s, label, &pieces);
    memory_free(label);
    size_t bytes = 0;
    struct solid_fragment *list = par_all_gather_any(part, (size_t)pieces * sizeof *part, &bytes);
    free(part);
    int n = (int)(bytes / sizeof *list);
    qsort(list, (size_t)n, sizeof *list, by_id);
    n = merge(list, n);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            list[i].x[c] /= list[i].mass;
            list[i].v[c] /= list[i].mass;
        }
    qsort(list, (size_t)n, sizeof *list, by_size);
    if (out)
        *out = list;
    else
        free(list);
    return n;
}
