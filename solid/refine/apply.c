/* Carries out a refinement: renumbers the particles, moves their state and renews their bonds. */
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/bonds/cut_bonds.h"
#include "solid/bonds/family.h"
#include "solid/bonds/list.h"
#include "solid/build.h"
#include "solid/contact/contact.h"
#include "solid/force/dilatation.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/refine/parts.h"

#include <string.h>

/* Number of values moved with a particle: d, v and the load without the input's loads, in both directions. */
enum { CARRIED = 6 };

static void carried_of(const struct solid *s, double *field[CARRIED]) {
    for (int c = 0; c < 2; c++) {
        field[c] = s->d[c];
        field[2 + c] = s->v[c];
        field[4 + c] = s->load[c];
    }
}

/* A body that is refined. */
struct change {
    const struct solid_refine_plan *plan;
    struct solid_cloud *cloud;       /* the new cloud */
    long *was;                       /* [cloud->n] numbers in the plan */
    double (*interpolated)[CARRIED]; /* [plan->n - plan->before] */
    struct solid_refine_broken *broken;
};

/* Gathers, from their owners, the values of the particles that new particles are interpolated from. */
static void sources_gather(const struct solid *s, const struct change *k, double (*value)[CARRIED], long *row) {
    const struct solid_refine_plan *p = k->plan;
    const long from = s->first[par_rank()] - p->cloud->first;
    double *field[CARRIED];
    long rows = 0;
    carried_of(s, field);
    for (long i = 0; i < p->n - p->before; i++)
        for (int q = 0; q < SOLID_REFINE_PARENTS; q++) {
            const long source = p->interpolated[i].source[q];
            if (p->interpolated[i].weight[q] == 0 || source >= p->before || row[source]) continue;
            row[source] = ++rows;
            if (source < from || source >= from + s->n) continue;
            for (int f = 0; f < CARRIED; f++) value[rows - 1][f] = field[f][source - from];
        }
    par_sum_array(&value[0][0], (int)(CARRIED * rows));
}

/* (000: sec. 2.1.3) */
static void interpolated_values(const struct solid *s, struct change *k) {
    const struct solid_refine_plan *p = k->plan;
    const long n = p->n - p->before;
    long *row = memory_new(MEMORY_SOLID, (size_t)p->before + 1, sizeof *row);
    double(*value)[CARRIED] = memory_new(MEMORY_SOLID, (size_t)(SOLID_REFINE_PARENTS * n) + 1, sizeof *value);
    k->interpolated = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *k->interpolated);
    sources_gather(s, k, value, row);
    for (long i = 0; i < n; i++)
        for (int f = 0; f < CARRIED; f++) {
            double part[SOLID_REFINE_PARENTS];
            for (int q = 0; q < SOLID_REFINE_PARENTS; q++) {
                const double weight = p->interpolated[i].weight[q];
                const long source = p->interpolated[i].source[q];
                part[q] = weight == 0          ? 0
                          : source < p->before ? weight * value[row[source] - 1][f]
                                               : weight * k->interpolated[source - p->before][f];
            }
            k->interpolated[i][f] = (part[0] + part[1]) + (part[2] + part[3]);
        }
    MEMORY_FREE(row, value);
}

/* The numbers of fragments, which may be followed from any time on. */
static void pieces_reserve(struct solid *s, int n) {
    const size_t used = (size_t)(n < s->n ? n : s->n), capacity = (size_t)n + 1;
    if (!s->fragment) return;
    s->fragment = memory_grown(MEMORY_SOLID, s->fragment, used, capacity, sizeof *s->fragment);
    s->fragment_since = memory_grown(MEMORY_SOLID, s->fragment_since, used, capacity, sizeof *s->fragment_since);
}

void solid_refine_apply_reserve(struct solid *s, int n) {
    pieces_reserve(s, n);
    if (n + 1 < s->refine->capacity) return;
    const size_t capacity = (size_t)(s->refine->capacity = n + n / 8 + 256), owned = (size_t)s->n;
    for (int c = 0; c < s->dim; c++) {
        double **const arrays[] = {&s->x0[c], &s->d[c], &s->v[c], &s->a[c], &s->load[c], &s->v_old[c], &s->a_old[c]};
        for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
            *arrays[k] = memory_grown(MEMORY_SOLID, *arrays[k], owned, capacity, sizeof(double));
    }
    s->volume = memory_grown(MEMORY_SOLID, s->volume, owned, capacity, sizeof(double));
    s->family_volume = memory_grown(MEMORY_SOLID, s->family_volume, owned, capacity, sizeof(double));
    s->body = memory_grown(MEMORY_SOLID, s->body, owned, capacity, 1);
    s->flag = memory_grown(MEMORY_SOLID, s->flag, owned, capacity, 1);
}

/* Moves the values of the bodies' owned particles to their new indices, the last body first, and sets those of new
 * particles. */
static void carry(struct solid *s, const struct change *change, const int *old_first) {
    double *field[CARRIED];
    const int *first = s->family->first;
    carried_of(s, field);
    for (int b = s->in.bodies - 1; b >= 0; b--) {
        const struct change *k = &change[b];
        const int stay = old_first[b + 1] - old_first[b], n = first[b + 1] - first[b];
        const long number = s->first[par_rank()] + first[b] - k->cloud->first;
        for (int f = 0; f < CARRIED; f++) {
            memmove(field[f] + first[b], field[f] + old_first[b], (size_t)stay * sizeof(double));
            for (int i = stay; i < n; i++)
                field[f][first[b] + i] = k->interpolated[k->was[number + i] - k->plan->before][f];
        }
        memmove(s->flag + first[b], s->flag + old_first[b], (size_t)stay);
        memset(s->flag + first[b] + stay, 0, (size_t)(n - stay));
        if (!s->fragment) continue;
        memmove(s->fragment + first[b], s->fragment + old_first[b], (size_t)stay * sizeof *s->fragment);
        memmove(s->fragment_since + first[b], s->fragment_since + old_first[b],
                (size_t)stay * sizeof *s->fragment_since);
        for (int i = stay; i < n; i++) s->fragment[first[b] + i] = -1;
    }
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->a[c][h] = s->v_old[c][h] = s->a_old[c][h] = 0;
}

/* Sets the flag of new particles that have inherited broken bonds. */
static void mark_broken(struct solid *s, const struct solid_list *list) {
    for (int i = 0; i < list->n; i++) {
        if (list->scaled[i]) continue;
        for (long j = list->start[i]; j < list->end[i]; j++)
            if (!solid_list_is_intact(list, j)) s->flag[list->first + i] |= SOLID_BROKEN;
    }
}

static void numbers_set(struct solid *s, struct change *change, struct solid_refine_plan *const *plan) {
    const int size = par_size();
    long *count = memory_new(MEMORY_SOLID, (size_t)size, sizeof *count), first = 0;
    for (int b = 0; b < s->in.bodies; b++) {
        change[b].plan = plan[b];
        change[b].cloud = solid_refine_cloud(s, b, plan[b], first, &change[b].was, count);
        first += change[b].cloud->n;
    }
    for (int r = 0; r < size; r++) s->first[r + 1] = s->first[r] + count[r];
    s->n_global = first;
    memory_free(count);
}

static void lists_renew(struct solid *s, struct change *change) {
    struct solid_family *f = s->family;
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    for (int b = 0; b < f->bodies; b++) {
        struct change *k = &change[b];
        long *was = memory_new(MEMORY_SOLID, (size_t)k->cloud->n + 1, sizeof *was);
        for (long i = 0; i < k->cloud->n; i++) was[i] = k->was[i] < k->plan->before ? k->was[i] : -1;
        struct solid_list *list = solid_list_renew(f->list[b], f->cloud[b], k->cloud, was, from, to, f->first[b]);
        solid_refine_broken_inherit(k->broken, list, k->cloud, k->was);
        solid_list_free(f->list[b]);
        solid_cloud_free(f->cloud[b]);
        f->list[b] = list;
        f->cloud[b] = k->cloud;
        f->first[b + 1] = f->first[b] + list->n;
        memory_free(was);
    }
    s->n = (int)(to - from);
}

/* Sets loads and imposed values at the present particles; s->load contains only the other loads before. */
static void impose(struct solid *s) {
    if (s->external_loads) {
        solid_external_loads_free(s->external_loads);
        s->external_loads = NULL;
        solid_external_loads_new(s, NULL, solid_refine_area_lengths);
    }
    solid_constraint_flags(s);
    solid_constraint_displacement(s, s->t);
    solid_constraint_velocity(s, s->t, 0);
}

void solid_refine_apply(struct solid *s, struct solid_refine_plan *const *plan) {
    struct solid_family *f = s->family;
    const size_t bodies = (size_t)f->bodies;
    struct change *change = memory_new(MEMORY_SOLID, bodies, sizeof *change);
    int *old_first = memory_new(MEMORY_SOLID, bodies + 1, sizeof *old_first);
    memcpy(old_first, f->first, (bodies + 1) * sizeof *old_first);
    for (int c = 0; s->external_loads && c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->load[c][h] -= solid_external_loads_on(s, h, c);
    for (int b = 0; b < f->bodies; b++) {
        change[b].plan = plan[b];
        interpolated_values(s, &change[b]);
        change[b].broken = solid_refine_broken_new(s, b, plan[b]);
    }
    solid_contact_free(s);
    numbers_set(s, change, plan);
    const int owned = (int)(s->first[par_rank() + 1] - s->first[par_rank()]);
    solid_refine_apply_reserve(s, owned);
    lists_renew(s, change);
    carry(s, change, old_first);
    par_ghost_free(s->ghost);
    solid_build_ghosts(s, NULL, f->cloud);
    solid_refine_apply_reserve(s, s->n + s->n_ghost);
    solid_build_places(s, NULL, f->cloud);
    solid_dilatation_renew(s);
    for (int b = 0; b < f->bodies; b++) mark_broken(s, f->list[b]);
    solid_cut_bonds(s, f->cloud);
    solid_build_edges(s);
    impose(s);
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    par_ghost_update(s->ghost, s->dim, s->v, s->n);
    solid_build_counts(s);
    s->a_holds = 0;
    s->refine->events++;
    for (int b = 0; b < f->bodies; b++) {
        solid_refine_broken_free(change[b].broken);
        MEMORY_FREE(change[b].was, change[b].interpolated);
    }
    MEMORY_FREE(old_first, change);
}
