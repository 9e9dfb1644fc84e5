/* Follows fragments in time: numbers, times of detachment, sizes. */
#include "solid/measure/detachment.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void solid_detachment_begin(struct solid *s) {
    if (s->fragment) return;
    s->fragment = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *s->fragment);
    s->fragment_since = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *s->fragment_since);
    for (int h = 0; h < s->n; h++) s->fragment[h] = -1;
}

/* A fragment's place in a list, to be found by its id. */
struct place {
    long id;
    int at;
};

static int by_id(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    return (p->id > q->id) - (p->id < q->id);
}

static int place_of(const struct place *place, int n, long id) {
    const struct place key = {id, 0};
    const struct place *found = bsearch(&key, place, (size_t)n, sizeof *place, by_id);
    return found ? found->at : -1;
}

static struct place *places_new(int n, const struct solid_fragment *list, const int *which) {
    struct place *place = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *place);
    for (int k = 0; k < n; k++) place[k] = (struct place){list[which ? which[k] : k].id, k};
    qsort(place, (size_t)n, sizeof *place, by_id);
    return place;
}

/* The index in the list of each owned particle's fragment; -1: not among those of the list. Most fragments have the id
 * of a particle owned here. */
static int *index_new(const struct solid *s, const long *id, int n, const struct solid_fragment *list,
                      const int *which) {
    const long from = s->first[par_rank()];
    struct place *place = places_new(n, list, which);
    int *at = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *at);
    int *own = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *own); /* of the fragment with that particle's id */
    for (int h = 0; h < s->n; h++) own[h] = -1;
    for (int k = 0; k < n; k++)
        if (place[k].id >= from && place[k].id < from + s->n) own[place[k].id - from] = place[k].at;
    for (int h = 0; h < s->n; h++) {
        const int is_own = id[h] >= from && id[h] < from + s->n;
        at[h] = is_own ? own[id[h] - from] : h > 0 && id[h] == id[h - 1] ? at[h - 1] : place_of(place, n, id[h]);
    }
    MEMORY_FREE(own, place);
    return at;
}

/* The particle of a fragment that comes first: the first in x, then in y. */
struct corner {
    double x[2];
    int at; /* of the fragment in the list */
};

static int by_fragment(const void *a, const void *b) {
    const struct corner *p = a, *q = b;
    if (p->at != q->at) return p->at < q->at ? -1 : 1;
    for (int c = 0; c < 2; c++)
        if (p->x[c] != q->x[c]) return p->x[c] < q->x[c] ? -1 : 1;
    return 0;
}

struct ordered {
    struct solid_fragment fragment;
    double x[2];
};

static int by_size_and_place(const void *a, const void *b) {
    const struct ordered *p = a, *q = b;
    if (p->fragment.particles != q->fragment.particles) return p->fragment.particles < q->fragment.particles ? 1 : -1;
    for (int c = 0; c < 2; c++)
        if (p->x[c] != q->x[c]) return p->x[c] < q->x[c] ? -1 : 1;
    return 0;
}

/* Orders equally large fragments by place. Ids of a refined plate depend on the number of ranks, which numbers must
 * not. Collective. */
static void order_by_place(const struct solid *s, const int *at, int n, struct solid_fragment *list) {
    struct corner *local = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *local);
    for (int h = 0; h < s->n; h++) local[h] = (struct corner){{s->x0[0][h], s->x0[1][h]}, at[h]};
    qsort(local, (size_t)s->n, sizeof *local, by_fragment);
    int found = 0;
    for (int h = 0; h < s->n; h++)
        if (h == 0 || local[h].at != local[h - 1].at) local[found++] = local[h];
    size_t bytes = 0;
    struct corner *all = par_all_gather_any(local, (size_t)found * sizeof *local, &bytes);
    const int m = (int)(bytes / sizeof *all);
    int k = 0;
    qsort(all, (size_t)m, sizeof *all, by_fragment);
    for (int i = 0; i < m; i++)
        if (i == 0 || all[i].at != all[i - 1].at) all[k++] = all[i];
    ENSURE(k == n, "%d of %d fragments have a particle", k, n);
    struct ordered *sorted = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *sorted);
    for (int i = 0; i < n; i++) sorted[i] = (struct ordered){list[i], {all[i].x[0], all[i].x[1]}};
    qsort(sorted, (size_t)n, sizeof *sorted, by_size_and_place);
    for (int i = 0; i < n; i++) list[i] = sorted[i].fragment;
    memory_free(sorted);
    free(all);
    memory_free(local);
}

/* Numbers the fragments by the numbers that their particles had before: was[n][2], number and time, or less than 0. */
static void number(int n, double (*was)[2], double t, struct solid_detachment *record) {
    long next = 0;
    for (int i = 0; i < n; i++)
        if (was[i][0] >= (double)next) next = lrint(was[i][0]) + 1;
    uint8_t *taken = memory_new(MEMORY_OUTPUT, (size_t)next + 1, 1);
    const int is_first = next == 0;
    for (int i = 0; i < n; i++) { /* the largest come first */
        const long before = was[i][0] >= 0 ? lrint(was[i][0]) : -1;
        const int keeps = before >= 0 && !taken[before];
        if (keeps) taken[before] = 1;
        record[i] = (struct solid_detachment){.number = keeps ? before : next,
                                              .from = keeps ? -1 : before,
                                              .since = keeps ? was[i][1] : t,
                                              .is_new = !keeps && !is_first};
        next += !keeps;
    }
    memory_free(taken);
}

int solid_detachment_update(struct solid *s, double t, long *id, struct solid_fragment **out,
                            struct solid_detachment **numbers) {
    ENSURE(s->fragment, "fragments are not followed");
    long *label = id ? id : memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *label);
    struct solid_fragment *list = NULL;
    const int n = solid_fragments_measure(s, label, &list);
    int *at = index_new(s, label, n, list, NULL);
    if (s->refine) {
        order_by_place(s, at, n, list);
        memory_free(at);
        at = index_new(s, label, n, list, NULL);
    }
    double(*was)[2] = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *was);
    for (int i = 0; i < n; i++) was[i][0] = was[i][1] = -INFINITY;
    for (int h = 0; h < s->n; h++) { /* all particles of a fragment have the same, but for those born since */
        was[at[h]][0] = fmax(was[at[h]][0], (double)s->fragment[h]);
        if (s->fragment[h] >= 0) was[at[h]][1] = fmax(was[at[h]][1], s->fragment_since[h]);
    }
    par_max_array(&was[0][0], 2 * n);
    struct solid_detachment *record = calloc((size_t)n + 1, sizeof *record);
    ENSURE(record, "no memory for %d fragments", n);
    number(n, was, t, record);
    for (int h = 0; h < s->n; h++) {
        s->fragment[h] = record[at[h]].number;
        s->fragment_since[h] = record[at[h]].since;
    }
    MEMORY_FREE(was, at);
    if (!id) memory_free(label);
    *out = list;
    *numbers = record;
    return n;
}

/* The directions along which extents are measured; of a plate those in its plane. */
enum { DIRECTIONS = 13, CHUNK = 4096 };
static const int direction[DIRECTIONS][3] = {{1, 0, 0},  {0, 1, 0},  {1, 1, 0}, {1, -1, 0}, {0, 0, 1},
                                             {1, 0, 1},  {1, 0, -1}, {0, 1, 1}, {0, 1, -1}, {1, 1, 1},
                                             {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

/* A fragment's places are taken relative to its particle with the smallest id: as they are, or to the nearest periodic
 * image, whichever makes the fragment shorter. */
struct frame {
    double x[3];     /* of that particle, m */
    int to_image[3]; /* 1: to the nearest image */
};

static void place_of_particle(const struct solid *s, int h, const struct frame *f, int c, double place[2]) {
    place[0] = s->x0[c][h] + s->d[c][h] - f->x[c];
    place[1] = solid_shortest(s, c, place[0]);
}

/* frame [n], at [s->n] */
static void frames_find(const struct solid *s, const long *id, const int *at, int n, struct frame *frame) {
    const long from = s->first[par_rank()];
    double(*x)[3] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *x);
    double(*reach)[3][2][2] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *reach); /* direction, form, sense */
    for (int h = 0; h < s->n; h++)
        if (at[h] >= 0 && id[h] == from + h)
            for (int c = 0; c < s->dim; c++) x[at[h]][c] = s->x0[c][h] + s->d[c][h];
    par_sum_array(&x[0][0], 3 * n);
    for (int k = 0; k < n; k++) memcpy(frame[k].x, x[k], sizeof x[k]);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; at[h] >= 0 && c < s->dim; c++) {
            double place[2];
            place_of_particle(s, h, &frame[at[h]], c, place);
            for (int form = 0; form < 2; form++) {
                double *to = reach[at[h]][c][form];
                to[0] = fmax(to[0], -place[form]);
                to[1] = fmax(to[1], place[form]);
            }
        }
    par_max_array(&reach[0][0][0][0], 12 * n);
    for (int k = 0; k < n; k++)
        for (int c = 0; c < 3; c++) {
            const double plain = reach[k][c][0][0] + reach[k][c][0][1], image = reach[k][c][1][0] + reach[k][c][1][1];
            frame[k].to_image[c] = image < plain - 0.5 * s->in.spacing;
        }
    MEMORY_FREE(reach, x);
}

/* Sums of volume and of mass times place, kg m, and the reach of -place and place along the directions, m. */
struct sums {
    double volume, moment[3], reach[2][DIRECTIONS];
};

static void sums_add(const struct solid *s, int h, const struct frame *frame, struct sums *to, int directions,
                     const double length[DIRECTIONS]) {
    const double mass = solid_density(s, h) * s->volume[h];
    double place[3] = {0};
    to->volume += s->volume[h];
    for (int c = 0; c < s->dim; c++) {
        double form[2];
        place_of_particle(s, h, frame, c, form);
        place[c] = form[frame->to_image[c]];
        to->moment[c] += mass * place[c];
    }
    for (int k = 0; k < directions; k++) {
        const int *e = direction[k];
        const double along = (e[0] * place[0] + e[1] * place[1] + e[2] * place[2]) / length[k];
        to->reach[0][k] = -along > to->reach[0][k] ? -along : to->reach[0][k];
        to->reach[1][k] = along > to->reach[1][k] ? along : to->reach[1][k];
    }
}

/* At most CHUNK fragments, so that the ranks exchange no more than that many at once. */
static void sizes_of_chunk(const struct solid *s, const long *id, const struct solid_fragment *list, int n,
                           const int *which, struct solid_detachment_size *size) {
    const int directions = s->dim == 3 ? DIRECTIONS : 4;
    int *at = index_new(s, id, n, list, which);
    struct frame *frame = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *frame);
    struct sums *sum = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *sum);
    double(*value)[4] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *value);
    double(*reach)[2 * DIRECTIONS] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *reach);
    double length[DIRECTIONS];
    for (int k = 0; k < DIRECTIONS; k++) {
        const int *e = direction[k];
        length[k] = sqrt((double)(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]));
    }
    frames_find(s, id, at, n, frame);
    for (int h = 0; h < s->n; h++)
        if (at[h] >= 0) sums_add(s, h, &frame[at[h]], &sum[at[h]], directions, length);
    for (int k = 0; k < n; k++) {
        value[k][0] = sum[k].volume;
        memcpy(value[k] + 1, sum[k].moment, sizeof sum[k].moment);
        memcpy(reach[k], sum[k].reach, sizeof sum[k].reach);
    }
    par_sum_array(&value[0][0], 4 * n);
    par_max_array(&reach[0][0], 2 * DIRECTIONS * n);
    for (int k = 0; k < n; k++) {
        size[k] = (struct solid_detachment_size){.volume = value[k][0]};
        for (int e = 0; e < directions; e++)
            size[k].extent = fmax(size[k].extent, reach[k][e] + reach[k][DIRECTIONS + e]);
        size[k].extent += s->in.spacing;
        for (int c = 0; c < 3; c++) size[k].centre[c] = frame[k].x[c] + value[k][1 + c] / list[which[k]].mass;
    }
    MEMORY_FREE(reach, value, sum, frame, at);
}

void solid_detachment_sizes(const struct solid *s, const long *id, const struct solid_fragment *list, int n,
                            const int *which, struct solid_detachment_size *size) {
    for (int k = 0; k < n; k += CHUNK) sizes_of_chunk(s, id, list, n - k < CHUNK ? n - k : CHUNK, which + k, size + k);
}
