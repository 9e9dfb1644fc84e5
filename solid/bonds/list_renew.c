/* Rebuilds the bond lists near changed particles and copies the others, after a refinement. */
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/bonds/list_find.h"

#include <math.h>
#include <string.h>

enum { UNTOUCHED, NEAR, FRESH };

/* The changes of a whole body. */
struct change {
    const struct solid_cloud *before, *cloud;
    const long *was; /* [cloud->n] number before, -1: new */
    long *now;       /* [before->n] number after, -1: gone */
    uint8_t *family; /* [cloud->n] FRESH: family to be found again; NEAR: a family of one of its other ends is FRESH */
    /* the particle whose neighbours are being marked */
    struct solid_end end;
    uint8_t as;
};

static int is_same(const struct change *k, long number) {
    const struct solid_cloud *a = k->cloud, *b = k->before;
    const long old = k->was[number];
    for (int c = 0; old >= 0 && c < a->dim; c++)
        if (a->place[c][number] != b->place[c][old]) return 0;
    return old >= 0 && a->size[number] == b->size[old] && a->volume[number] == b->volume[old] &&
           a->horizon[number] == b->horizon[old];
}

/* Marks the families that contain, or contained, a particle. */
static void mark(void *with, long number, int image, const double xi[3]) {
    struct change *k = with;
    (void)image;
    if (k->family[number] >= k->as) return;
    const struct solid_end end = solid_cloud_end(k->cloud, number);
    if (solid_pair_exists(&k->cloud->law, xi, &end, &k->end)) k->family[number] = k->as;
}

static void mark_about(struct change *k, const struct solid_cloud *from, long number, uint8_t as) {
    double place[3] = {0};
    for (int c = 0; c < from->dim; c++) place[c] = from->place[c][number];
    k->end = solid_cloud_end(from, number);
    k->as = as;
    solid_cloud_near_visit(k->cloud, place, fmax(k->before->longest_reach, k->cloud->longest_reach), mark, k);
}

static void change_begin(struct change *k) {
    k->now = memory_new(MEMORY_SOLID, (size_t)k->before->n + 1, sizeof *k->now);
    k->family = memory_new(MEMORY_SOLID, (size_t)k->cloud->n + 1, 1);
    for (long old = 0; old < k->before->n; old++) k->now[old] = -1;
    for (long number = 0; number < k->cloud->n; number++) {
        if (k->was[number] >= 0) k->now[k->was[number]] = number;
        if (is_same(k, number)) continue;
        k->family[number] = FRESH;
        mark_about(k, k->cloud, number, FRESH);
    }
    for (long old = 0; old < k->before->n; old++)
        if (k->now[old] < 0 || !is_same(k, k->now[old])) mark_about(k, k->before, old, FRESH);
    for (long number = 0; number < k->cloud->n; number++)
        if (k->family[number] == FRESH) mark_about(k, k->cloud, number, NEAR);
}

static void change_end(struct change *k) { MEMORY_FREE(k->now, k->family); }

/* The present key of the other end of an old bond, or -1. */
static long key_now(const struct change *k, const struct solid_list *old, int record) {
    const int is_own = record < old->n;
    const long key = is_own ? 0 : old->other_key[record - old->n];
    const long number = is_own ? old->number + record : solid_key_id(key) - old->first_id;
    const long now = k->now[number];
    return now < 0 ? -1 : solid_key_of(k->cloud->first + now, is_own ? SOLID_NO_IMAGE : solid_key_image(key));
}

/* Copies a family with its alpha. Bonds to owned particles, which keep their order, need no key. */
static void copy_family(struct solid_list *list, const struct solid_list *old, const struct change *k, int i, int o) {
    const long from = old->start[o], to = list->start[i];
    const size_t n = (size_t)(old->end[o] - from),
                 blocks = (n + SOLID_LIST_BLOCK - 1) / SOLID_LIST_BLOCK * SOLID_LIST_BLOCK;
    memcpy(list->at + to, old->at + from, blocks * sizeof *list->at);
    memcpy(list->step + to * list->dim, old->step + from * list->dim, blocks * (size_t)list->dim * sizeof *list->step);
    memcpy(list->stiffness + to, old->stiffness + from, blocks * sizeof *list->stiffness);
    list->eps_limit[i] = old->eps_limit[o];
    list->digit[i] = old->digit[o];
    list->power[i] = old->power[o];
    list->own_volume[i] = old->own_volume[o];
    list->scaled[i] = SOLID_LIST_LINKED;
    for (size_t j = 0; old->others > 0 && j < n; j++) {
        const int record = solid_list_record(old, from + (long)j);
        list->key[to + (long)j] = record < old->n ? -1 : key_now(k, old, record);
        if (record >= old->n) list->scaled[i] = SOLID_LIST_SCALED;
    }
}

/* Computes the numbers of a family, without alpha. */
static void number_family(struct solid_list *list, const struct solid_list *old, const struct change *k, int i, int o,
                          long number) {
    const long from = old->start[o], to = list->start[i], n = old->end[o] - from;
    for (long j = 0; j < n; j++) list->key[to + j] = key_now(k, old, solid_list_record(old, from + j));
    solid_list_find_number(list, k->cloud, i, number);
    for (long j = 0; j < n; j++) solid_list_set(list, to + j, solid_list_is_intact(old, from + j));
}

/* Breaks the bonds that were broken before. */
static void keep_broken(struct solid_list *list, const struct solid_list *old, const struct change *k, int i, int o) {
    for (long j = old->start[o]; j < old->end[o]; j++) {
        if (solid_list_is_intact(old, j)) continue;
        const long key = key_now(k, old, solid_list_record(old, j));
        for (long q = list->start[i]; q < list->end[i]; q++)
            if (list->key[q] == key) solid_list_set(list, q, 0);
    }
}

struct solid_list *solid_list_renew(const struct solid_list *old, const struct solid_cloud *before,
                                    const struct solid_cloud *cloud, const long *was, long from, long to, int first) {
    struct change k = {.before = before, .cloud = cloud, .was = was};
    struct solid_list *list = solid_list_find_begin(cloud, from, to, first);
    struct solid_cloud_near *near = memory_new(MEMORY_SOLID, 1, sizeof *near);
    change_begin(&k);
    for (int i = 0; i < list->n; i++) {
        const long number = list->number + i, o = was[number] - old->number;
        ENSURE(was[number] < 0 || (o >= 0 && o < old->n), "particle %ld was not of this rank", number);
        list->end[i] = k.family[number] == FRESH ? solid_cloud_near_count(cloud, number) : old->end[o] - old->start[o];
    }
    solid_list_find_allocate(list);
    for (int i = 0; i < list->n; i++) {
        const long number = list->number + i;
        const int o = (int)(was[number] - old->number), is_old = was[number] >= 0;
        if (is_old) list->large[i] = old->large[o];
        if (k.family[number] == UNTOUCHED) {
            copy_family(list, old, &k, i, o);
        } else if (k.family[number] == NEAR) {
            number_family(list, old, &k, i, o, number);
        } else {
            solid_list_find(list, cloud, i, number, near);
            if (is_old) keep_broken(list, old, &k, i, o);
        }
    }
    change_end(&k);
    memory_free(near);
    return list;
}
