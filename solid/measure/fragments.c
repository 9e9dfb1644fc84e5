/* Finds the fragments: connected components of intact bonds over all ranks, with mass, centre and velocity. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/vec.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"
#include "solid/measure/fragments.h"

#include <stdlib.h>

/* The trees of particles that are connected by intact bonds, among those on this rank, owned or ghost. parent: of each
 * particle; the root is the one with the smallest index. */
static int find(int *parent, int h) {
    while (parent[h] != h) h = parent[h] = parent[parent[h]];
    return h;
}

static int join(int *parent, int a, int b) {
    a = find(parent, a);
    b = find(parent, b);
    const int root = a < b ? a : b;
    return parent[a] = parent[b] = root;
}

/* Joins a row's particles with their neighbours at offset o. piece [sites]: the root of the site's particle, possibly
 * out of date; only particles with different roots are joined. */
static inline void join_at(const struct solid_lattice *lattice, int cell, int o, unsigned intact, int *piece,
                           int *parent) {
    const long at = cell + lattice->offset[o].shift;
    for (unsigned lanes = intact & vec_differ(piece + cell, piece + at); lanes; lanes &= lanes - 1) {
        const int k = __builtin_ctz(lanes);
        piece[cell + k] = piece[at + k] = join(parent, lattice->local[cell + k], lattice->local[at + k]);
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

/* Nearest neighbours first: most of a body is then connected, and the other bonds need little work. */
static void join_lattice(const struct solid_lattice *lattice, int *parent) {
    int *piece = memory_new(MEMORY_SOLID, (size_t)lattice->sites + 2 * SOLID_ROW, sizeof *piece);
    const int offsets = lattice->stencil->n;
    for (long i = 0; i < lattice->sites; i++) piece[i] = lattice->local[i];
    for (int o = 0; o < offsets; o++) {
        if (lattice->stencil->offset[o].length > 1.1 * lattice->stencil->spacing) continue;
        for (int r = 0; r < lattice->rows; r++)
            join_at(lattice, lattice->row_cell[r], o, lattice->lambda[(size_t)r * (size_t)offsets + (size_t)o], piece,
                    parent);
    }
    for (long i = 0; i < lattice->sites; i++) piece[i] = lattice->local[i] < 0 ? -1 : find(parent, lattice->local[i]);
    for (int g = 0; g < lattice->segments->n; g++) join_segment(lattice, g, piece, parent);
    memory_free(piece);
}

static void join_list(const struct solid_list *list, int *parent) {
    for (int i = 0; i < list->n; i++)
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const int l = solid_list_other(list, j);
            if (solid_list_is_intact(list, j) && parent[list->first + i] != parent[l]) join(parent, list->first + i, l);
        }
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
    for (int h = 0; h < n; h++) parent[h] = find(parent, h);
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
        for (int h = 0; h < s->n; h++) label[h] = label[parent[h]];
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

    int mine = 0;
    struct solid_fragment *part = parts(s, label, &mine);
    memory_free(label);
    size_t bytes = 0;
    struct solid_fragment *list = par_all_gather_any(part, (size_t)mine * sizeof *part, &bytes);
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
