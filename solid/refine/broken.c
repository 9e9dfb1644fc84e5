/* Inherited breaks: a new bond is broken if a bond between its ends' parents was. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/list_find.h"
#include "solid/refine/parts.h"

#include <stdlib.h>

enum { ANCESTORS = 64 };

struct pair {
    long one, two; /* one < two */
};

struct solid_refine_broken {
    const struct solid_refine_plan *plan; /* borrowed */
    long pairs;
    struct pair *pair; /* ascending, malloc'ed */
    uint8_t *is_end;   /* [before] 1: an end of one of the pairs */
};

/* The old particles that a particle of the plan descends from. */
static int ancestors_of(const struct solid_refine_plan *p, long i, long ancestor[ANCESTORS], int n) {
    if (i < p->before) {
        for (int k = 0; k < n; k++)
            if (ancestor[k] == i) return n;
        ENSURE(n < ANCESTORS, "a particle of more than %d", ANCESTORS);
        ancestor[n] = i;
        return n + 1;
    }
    const struct solid_refine_interpolated *interpolated = &p->interpolated[i - p->before];
    for (int k = 0; k < interpolated->parents; k++) n = ancestors_of(p, interpolated->parent[k], ancestor, n);
    return n;
}

static int by_pair(const void *a, const void *b) {
    const struct pair *x = a, *y = b;
    return x->one != y->one ? (x->one > y->one) - (x->one < y->one) : (x->two > y->two) - (x->two < y->two);
}

static struct pair pair_of(long a, long b) { return a < b ? (struct pair){a, b} : (struct pair){b, a}; }

/* Number of the particle of a record. */
static long number_of(const struct solid_list *list, int record) {
    return record < list->n ? list->number + record : solid_key_id(list->other_key[record - list->n]) - list->first_id;
}

/* The pairs of broken bonds of owned particles with an ancestor at one end. Written to pair unless that is NULL;
 * returns how many. */
static long find(const struct solid *s, const struct solid_list *list, const uint8_t *is_ancestor, struct pair *pair) {
    long n = 0;
    for (int i = 0; i < list->n; i++) {
        if (!(s->flag[list->first + i] & SOLID_BROKEN)) continue;
        for (long j = list->start[i]; j < list->end[i]; j++) {
            if (solid_list_is_intact(list, j)) continue;
            const long here = list->number + i, there = number_of(list, solid_list_record(list, j));
            if (!is_ancestor[here] && !is_ancestor[there]) continue;
            if (pair) pair[n] = pair_of(here, there);
            n++;
        }
    }
    return n;
}

struct solid_refine_broken *solid_refine_broken_new(const struct solid *s, int body,
                                                    const struct solid_refine_plan *p) {
    const struct solid_list *list = s->family->list[body];
    struct solid_refine_broken *broken = memory_new(MEMORY_SOLID, 1, sizeof *broken);
    uint8_t *is_ancestor = memory_new(MEMORY_SOLID, (size_t)p->before + 1, 1);
    for (long i = p->before; i < p->n; i++) {
        long ancestor[ANCESTORS];
        for (int n = ancestors_of(p, i, ancestor, 0); n > 0; n--) is_ancestor[ancestor[n - 1]] = 1;
    }
    const long local = find(s, list, is_ancestor, NULL);
    struct pair *pair = memory_new(MEMORY_SOLID, (size_t)local + 1, sizeof *pair);
    find(s, list, is_ancestor, pair);
    size_t bytes;
    broken->plan = p;
    broken->pair = par_all_gather_any(pair, (size_t)local * sizeof *pair, &bytes);
    broken->pairs = (long)(bytes / sizeof *pair);
    qsort(broken->pair, (size_t)broken->pairs, sizeof *pair, by_pair);
    broken->is_end = memory_new(MEMORY_SOLID, (size_t)p->before + 1, 1);
    for (long k = 0; k < broken->pairs; k++)
        broken->is_end[broken->pair[k].one] = broken->is_end[broken->pair[k].two] = 1;
    MEMORY_FREE(pair, is_ancestor);
    return broken;
}

void solid_refine_broken_free(struct solid_refine_broken *broken) {
    free(broken->pair);
    MEMORY_FREE(broken->is_end, broken);
}

static int was_broken(const struct solid_refine_broken *broken, const long *a, int as, const long *b, int bs) {
    for (int k = 0; k < as; k++)
        for (int l = 0; broken->is_end[a[k]] && l < bs; l++) {
            if (!broken->is_end[b[l]]) continue;
            const struct pair pair = pair_of(a[k], b[l]);
            if (bsearch(&pair, broken->pair, (size_t)broken->pairs, sizeof pair, by_pair)) return 1;
        }
    return 0;
}

void solid_refine_broken_inherit(const struct solid_refine_broken *broken, struct solid_list *list,
                                 const struct solid_cloud *cloud, const long *was) {
    const struct solid_refine_plan *p = broken->plan;
    for (int i = 0; broken->pairs > 0 && i < list->n; i++) {
        if (list->scaled[i]) continue; /* a copied family */
        long here[ANCESTORS], there[ANCESTORS];
        const long one = was[list->number + i];
        const int heres = ancestors_of(p, one, here, 0);
        int any = 0;
        for (int k = 0; k < heres; k++) any |= broken->is_end[here[k]];
        if (!any) continue;
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const long two = was[solid_key_id(list->key[j]) - cloud->first];
            if (one < p->before && two < p->before) continue;
            if (was_broken(broken, here, heres, there, ancestors_of(p, two, there, 0))) solid_list_set(list, j, 0);
        }
    }
}
