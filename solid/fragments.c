#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/family.h"
#include "solid/lattice.h"
#include "solid/list.h"
#include "solid/measures.h"

#include <stdlib.h>

enum { ROW = 8 };

/* The other ends (local indices) of h's intact bonds; returns how many. The view would do; this is many times in a run. */
static int links(const struct solid *s, int h, int l[SOLID_FAMILY_MAX]) {
    const struct solid_lattice *t = s->family->lattice[s->body[h]];
    int n = 0;
    if (t) {
        const int cell = t->cell[h - t->first], bit = cell % ROW, *local = t->local + cell;
        const uint8_t *lambda = t->lambda + (size_t)t->row_of[cell / ROW] * (size_t)t->stencil->n;
        for (int o = 0; o < t->stencil->n; o++) {
            l[n] = local[t->offset[o].shift];
            n += lambda[o] >> bit & 1; /* no bond was ever made to an empty site */
        }
    } else {
        const struct solid_list *list = s->family->list[s->body[h]];
        for (long j = list->start[h - list->first]; j < list->start[h - list->first + 1]; j++) {
            l[n] = list->l[j];
            n += list->intact[j];
        }
    }
    return n;
}

/* A bond from one local piece to a ghost. */
struct crossing {
    int root, ghost;
};

static int find(int *parent, int h) {
    while (parent[h] != h) h = parent[h] = parent[parent[h]];
    return h;
}

/* The smaller index is the root, which is returned: local indices rise with global ids. */
static int join(int *parent, int a, int b) {
    a = find(parent, a);
    b = find(parent, b);
    const int root = a < b ? a : b;
    return parent[a] = parent[b] = root;
}

/* Local pieces: parent[n] pressed flat; returns the bonds to ghosts (malloc'ed), about one for each ghost. */
static struct crossing *pieces(const struct solid *s, int *parent, int *crossings) {
    int l[SOLID_FAMILY_MAX + 1];
    struct crossing *cross = NULL;
    int n = 0, capacity = 0;
    int *seen = malloc(((size_t)s->n_ghost + 1) * sizeof *seen); /* who was last bonded to the ghost */
    ENSURE(seen, "no memory for %d ghosts", s->n_ghost);
    for (int g = 0; g < s->n_ghost; g++) seen[g] = -1;
    for (int h = 0; h < s->n; h++) parent[h] = h;
    for (int h = 0; h < s->n; h++) {
        const int bonds = links(s, h, l);
        int root = h; /* h's own, as long as it stands */
        for (int b = 0; b < bonds; b++) {
            if (l[b] < h) {
                if (parent[l[b]] != root) root = join(parent, h, l[b]);
            } else if (l[b] >= s->n) {
                int *who = &seen[l[b] - s->n];
                if (*who >= 0 && find(parent, *who) == find(parent, h)) continue;
                *who = h;
                if (n == capacity) {
                    capacity = 2 * capacity + 256;
                    cross = realloc(cross, (size_t)capacity * sizeof *cross);
                    ENSURE(cross, "no memory for %d bonds across ranks", capacity);
                }
                cross[n++] = (struct crossing){h, l[b]};
            }
        }
    }
    free(seen);
    for (int h = 0; h < s->n; h++) parent[h] = find(parent, h);
    for (int k = 0; k < n; k++) cross[k].root = parent[cross[k].root];
    *crossings = n;
    return cross;
}

/* The smallest global id of each fragment, in label[n + n_ghost]: pieces take the smallest label across their bonds to
 * ghosts until no rank finds a smaller one. */
static void spread(struct solid *s, const int *parent, const struct crossing *cross, int crossings,
                   double *label) {
    const long from = s->first[par_rank()];
    for (int h = 0; h < s->n; h++) label[h] = (double)(from + parent[h]);
    for (long changed = 1; changed;) {
        changed = 0;
        par_ghost_update(s->ghost, 1, &label, s->n);
        for (int k = 0; k < crossings; k++)
            if (label[cross[k].ghost] < label[cross[k].root]) {
                label[cross[k].root] = label[cross[k].ghost];
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

/* Adds up neighbours with the same id in a sorted list; returns how many are left. Sums are kept in x and v. */
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
        const double mass = s->in.material[s->in.body[s->body[h]].material].density * s->volume[h];
        f->particles++;
        f->mass += mass;
        f->held |= (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) != 0;
        for (int c = 0; c < 3; c++) {
            f->x[c] += mass * (s->x0[c][h] + s->d[c][h]);
            f->v[c] += mass * s->v[c][h];
        }
    }
    qsort(list, (size_t)m, sizeof *list, by_id);
    *n = merge(list, m);
    return list;
}

int solid_measure_fragments(struct solid *s, long *id, struct solid_fragment **out) {
    int *parent = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *parent);
    double *label = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *label);
    int crossings = 0;
    struct crossing *cross = pieces(s, parent, &crossings);
    spread(s, parent, cross, crossings, label);
    free(cross);
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
