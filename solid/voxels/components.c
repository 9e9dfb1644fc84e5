/* Labels connected pieces of an image: runs along x, united with those below and behind by union-find. */
#include "solid/voxels/components.h"
#include "base/ensure.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { NONE = UINT32_MAX, AT_LOW = 1, AT_HIGH = 8, BOXED = 64, LOOSE = 128 };

struct run {
    int from, to; /* voxels from <= i < to */
    uint32_t label;
};

struct slice {
    struct run *run;
    long n, capacity;
    long *row; /* [ny + 1] first run of each line */
};

struct sweep {
    const struct solid_voxels *v;
    struct solid_components *c;
    const int *wraps;
    int boxes;
    const int (*box)[2][3];
    uint64_t *bits; /* NULL: pieces are found; else: those that are known are visited, and the loose ones set here */
    uint32_t next;  /* label of the next run that continues none */
    uint64_t *line; /* [words] */
};

/* The first label of the piece, halving the way to it. */
static uint32_t root_of(uint32_t *parent, uint32_t a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
}

static void unite(struct sweep *s, uint32_t a, uint32_t b) {
    if (s->bits || a == b) return;
    a = root_of(s->c->parent, a);
    b = root_of(s->c->parent, b);
    if (a < b)
        s->c->parent[b] = a;
    else
        s->c->parent[a] = b;
}

static uint32_t label_new(struct sweep *s) {
    struct solid_components *c = s->c;
    const uint32_t label = s->next++;
    if (s->bits) return label;
    ENSURE(label < NONE - 1, "an image of more than %u pieces of runs", label);
    if (label == c->capacity) {
        const size_t larger = c->capacity ? (size_t)c->capacity * 3 / 2 : 1024;
        const size_t capacity = larger < NONE ? larger : NONE - 1;
        c->parent = memory_grown(MEMORY_SOLID, c->parent, label, capacity, sizeof *c->parent);
        c->size = memory_grown(MEMORY_SOLID, c->size, label, capacity, sizeof *c->size);
        c->mark = memory_grown(MEMORY_SOLID, c->mark, label, capacity, sizeof *c->mark);
        c->capacity = (uint32_t)capacity;
    }
    c->parent[label] = label;
    c->size[label] = 0;
    c->mark[label] = 0;
    c->labels = label + 1;
    return label;
}

/* The next run of ones at or after place i of a line of n. Returns 0 at its end. */
static int run_next(const uint64_t *line, int n, int i, struct run *run) {
    if (i >= n) return 0;
    long w = i / 64;
    const long words = (n + 63) / 64;
    uint64_t word = line[w] & ~(uint64_t)0 << i % 64;
    while (!word)
        if (++w < words)
            word = line[w];
        else
            return 0;
    run->from = (int)(64 * w) + __builtin_ctzll(word);
    word = ~line[w] & ~(uint64_t)0 << run->from % 64;
    while (!word)
        if (++w < words)
            word = ~line[w];
        else
            break;
    run->to = word && w < words ? (int)(64 * w) + __builtin_ctzll(word) : n;
    if (run->to > n) run->to = n;
    run->label = NONE;
    return 1;
}

/* Gives the runs first .. last of a line the labels of the runs that they touch in another line. */
static void touch(struct sweep *s, struct run *first, const struct run *last, const struct run *other,
                  const struct run *end) {
    for (struct run *run = first; run < last; run++) {
        while (other < end && other->to <= run->from) other++;
        for (const struct run *o = other; o < end && o->from < run->to; o++) {
            if (run->label == NONE) run->label = o->label;
            unite(s, run->label, o->label);
        }
    }
}

static void account(struct sweep *s, const struct run *run, int j, int k) {
    struct solid_components *c = s->c;
    const int *n = s->v->n, low[3] = {run->from, j, k}, high[3] = {run->to, j + 1, k + 1};
    unsigned mark = 0;
    for (int d = 0; d < 3; d++) {
        if (low[d] == 0) mark |= (unsigned)AT_LOW << d;
        if (high[d] == n[d]) mark |= (unsigned)AT_HIGH << d;
    }
    for (int b = 0; b < s->boxes; b++) {
        int d = 0;
        while (d < 3 && low[d] < s->box[b][1][d] && high[d] > s->box[b][0][d]) d++;
        if (d == 3) mark |= BOXED;
    }
    c->mark[run->label] |= (uint8_t)mark;
    c->size[run->label] += run->to - run->from;
}

static void set_floating(const struct sweep *s, const struct run *run, int j, int k) {
    if (!(s->c->mark[s->c->parent[run->label]] & LOOSE)) return;
    for (int i = run->from; i < run->to; i++) solid_voxels_set(s->v, s->bits, i, j, k);
}

static void run_add(struct slice *to, struct run run) {
    if (to->n == to->capacity) {
        to->capacity *= 2;
        to->run = memory_grown(MEMORY_SOLID, to->run, (size_t)to->n, (size_t)to->capacity, sizeof *to->run);
    }
    to->run[to->n++] = run;
}

/* One slice: runs of each line, labels from the line before and from the slice below. */
static void sweep_slice(struct sweep *s, struct slice *now, const struct slice *below, int k) {
    const int *n = s->v->n;
    now->n = 0;
    for (int j = 0; j < n[1]; j++) {
        struct run run = {.to = 0};
        solid_voxels_of(s->v, s->c->phase, j, k, s->line);
        now->row[j] = now->n;
        while (run_next(s->line, n[0], run.to, &run)) run_add(now, run);
        now->row[j + 1] = now->n;
        struct run *first = now->run + now->row[j];
        const struct run *last = now->run + now->n;
        if (j > 0) touch(s, first, last, now->run + now->row[j - 1], first);
        if (k > 0) touch(s, first, last, below->run + below->row[j], below->run + below->row[j + 1]);
        for (struct run *r = first; r < last; r++) {
            if (r->label == NONE) r->label = label_new(s);
            if (s->bits)
                set_floating(s, r, j, k);
            else
                account(s, r, j, k);
        }
        if (s->wraps[0] && last - first > 1 && first->from == 0 && last[-1].to == n[0])
            unite(s, first->label, last[-1].label);
    }
    if (s->wraps[1] && n[1] > 1)
        touch(s, now->run + now->row[n[1] - 1], now->run + now->n, now->run, now->run + now->row[1]);
}

static struct slice slice_new(const int n[3]) {
    struct slice slice = {.row = memory_new(MEMORY_SOLID, (size_t)n[1] + 1, sizeof(long)), .capacity = 1024};
    slice.run = memory_new(MEMORY_SOLID, (size_t)slice.capacity, sizeof *slice.run);
    return slice;
}

static void slice_free(struct slice *slice) { MEMORY_FREE(slice->run, slice->row); }

static void sweep_all(struct sweep *s) {
    const int *n = s->v->n;
    struct slice slices[3] = {slice_new(n), slice_new(n), slice_new(n)}; /* two in turn, and the first one */
    s->line = memory_new(MEMORY_SOLID, (size_t)s->v->words, sizeof *s->line);
    s->next = 0;
    for (int k = 0; k < n[2]; k++) {
        struct slice *now = k == 0 ? &slices[2] : &slices[k % 2];
        sweep_slice(s, now, k == 1 ? &slices[2] : &slices[(k + 1) % 2], k);
        for (int j = 0; k > 0 && k == n[2] - 1 && s->wraps[2] && j < n[1]; j++)
            touch(s, now->run + now->row[j], now->run + now->row[j + 1], slices[2].run + slices[2].row[j],
                  slices[2].run + slices[2].row[j + 1]);
    }
    for (int i = 0; i < 3; i++) slice_free(&slices[i]);
    memory_free(s->line);
    s->line = NULL;
}

/* Adds the labels up to pieces, and marks the loose ones. */
static void gather(struct solid_components *c) {
    uint32_t largest = NONE;
    for (uint32_t a = 0; a < c->labels; a++) { /* a root comes before its other labels */
        const uint32_t root = c->parent[a] = root_of(c->parent, a);
        c->voxels += c->size[a];
        if (root == a) continue;
        c->size[root] += c->size[a];
        c->mark[root] |= c->mark[a];
    }
    for (uint32_t a = 0; a < c->labels; a++) {
        if (c->parent[a] != a) continue;
        c->pieces++;
        for (int d = 0; d < 3; d++)
            if (c->mark[a] >> d & AT_LOW && c->mark[a] >> d & AT_HIGH) c->through[d] += c->size[a];
        if (largest == NONE || c->size[a] > c->size[largest]) largest = a;
    }
    c->largest = largest == NONE ? 0 : c->size[largest];
    for (uint32_t a = 0; a < c->labels; a++) {
        if (c->parent[a] != a || a == largest || c->mark[a] & BOXED) continue;
        c->mark[a] |= LOOSE;
        c->floating_pieces++;
        c->floating_voxels += c->size[a];
        if (c->size[a] > c->floating_largest) c->floating_largest = c->size[a];
    }
}

struct solid_components *solid_components_new(const struct solid_voxels *v, int phase, const int wraps[3], int boxes,
                                              const int (*box)[2][3]) {
    struct solid_components *c = memory_new(MEMORY_SOLID, 1, sizeof *c);
    c->phase = phase;
    sweep_all(&(struct sweep){.v = v, .c = c, .wraps = wraps, .boxes = boxes, .box = box});
    gather(c);
    return c;
}

void solid_components_free(struct solid_components *c) {
    if (!c) return;
    MEMORY_FREE(c->parent, c->size, c->mark, c);
}

void solid_components_floating(const struct solid_components *c, const struct solid_voxels *v, uint64_t *bits) {
    struct solid_components known = *c; /* its labels are read only */
    sweep_all(&(struct sweep){.v = v, .c = &known, .wraps = (const int[3]){0}, .bits = bits});
}
