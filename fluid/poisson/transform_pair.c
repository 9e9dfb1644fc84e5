/* Moves real lines to rows of vectors, several lines at once, transforms them and moves them back. */
#include "fluid/poisson/transform_pair.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/threads.h"
#include "base/vec_shuffle.h"
#include "fluid/poisson/fourier.h"

#include <stdlib.h>

enum {
    LINES = FLUID_FOURIER_ROW, /* at once */
    APART = 9 * LINES          /* between two arrays of scratch, so that their rows do not share sets of the cache */
};

struct fluid_transform_pair {
    struct fluid_transform_input in;
    int along; /* 1: lines are contiguous (x); 0: neighbouring values belong to neighbouring lines (y, z) */
    struct fluid_fourier *fourier;
    double *scratch; /* of each thread, two arrays of [n][LINES] */
    size_t capacity; /* of a thread */
};

struct fluid_transform_pair *fluid_transform_pair_new(const struct fluid_transform_input *in) {
    const int along = in->stride == 1 && in->distance >= in->n && in->n > 1, n = in->n;
    if (in->low != in->high || in->low == FLUID_END_FACE || (!along && in->distance != 1)) return NULL;
    ENSURE(!along || !in->out_stride || in->out_stride == 1, "values of a line written %d apart", in->out_stride);
    struct fluid_fourier *fourier = fluid_fourier_new(n, in->low);
    if (!fourier) return NULL;
    struct fluid_transform_pair *t = calloc(1, sizeof *t);
    t->in = *in;
    if (!in->out_stride) {
        t->in.out_stride = in->stride;
        t->in.out_distance = in->distance;
    }
    t->along = along;
    t->fourier = fourier;
    t->capacity = 2 * ((size_t)n * LINES + APART);
    t->scratch = memory_new(MEMORY_FLUID, t->capacity * (size_t)threads_count(), sizeof(double));
    return t;
}

void fluid_transform_pair_free(struct fluid_transform_pair *t) {
    if (!t) return;
    fluid_fourier_free(t->fourier);
    memory_free(t->scratch);
    free(t);
}

/* Where the lines of a call are. */
struct lines {
    int count, stride, distance;
};

/* Reads up to LINES lines into rows; lines that are missing repeat the last one. */
static void take(const struct fluid_transform_pair *t, struct lines group, const double *restrict q,
                 double *restrict rows) {
    const int n = t->in.n, whole = t->along ? n / VEC_LANES * VEC_LANES : 0;
    const double *line[LINES];
    for (int l = 0; l < LINES; l++) line[l] = q + (ptrdiff_t)(l < group.count ? l : group.count - 1) * group.distance;
    for (int block = 0; block < LINES; block += VEC_LANES)
        for (int j = 0; j < whole; j += VEC_LANES) {
            vec a[VEC_LANES];
            for (int l = 0; l < VEC_LANES; l++) a[l] = vec_load(line[block + l] + j);
            vec_shuffle_transpose(a);
            for (int i = 0; i < VEC_LANES; i++) vec_store(rows + (j + i) * LINES + block, a[i]);
        }
    for (int j = whole; j < n; j++)
        for (int l = 0; l < LINES; l++) rows[j * LINES + l] = line[l][(ptrdiff_t)j * group.stride];
}

/* The reverse. */
static void put(const struct fluid_transform_pair *t, struct lines group, const double *restrict rows,
                double *restrict q) {
    const int n = t->in.n, whole = t->along && group.count == LINES ? n / VEC_LANES * VEC_LANES : 0;
    for (int block = 0; block < LINES; block += VEC_LANES)
        for (int j = 0; j < whole; j += VEC_LANES) {
            vec a[VEC_LANES];
            for (int i = 0; i < VEC_LANES; i++) a[i] = vec_load(rows + (j + i) * LINES + block);
            vec_shuffle_transpose(a);
            for (int l = 0; l < VEC_LANES; l++) vec_store(q + (ptrdiff_t)(block + l) * group.distance + j, a[l]);
        }
    for (int j = whole; j < n; j++)
        for (int l = 0; l < group.count; l++)
            q[(ptrdiff_t)l * group.distance + (ptrdiff_t)j * group.stride] = rows[j * LINES + l];
}

/* Whether lines are rows where they are. */
static int are_rows(const struct fluid_transform_pair *t, struct lines group) {
    return !t->along && group.count == LINES;
}

static struct lines lines_from(const struct fluid_transform_pair *t, int first, int stride, int distance) {
    const int left = t->in.lines - first;
    return (struct lines){left < LINES ? left : LINES, stride, distance};
}

typedef struct fluid_fourier_rows transform(const struct fluid_fourier *f, struct fluid_fourier_rows from,
                                            struct fluid_fourier_rows to, double *const scratch[2]);

static void transform_lines(const struct fluid_transform_pair *t, transform *of_rows, struct lines in, double *from,
                            struct lines out, double *to) {
    double *const local = t->scratch + (size_t)threads_me() * t->capacity;
    double *const scratch[2] = {local, local + t->capacity / 2};
    if (are_rows(t, in)) {
        of_rows(t->fourier, (struct fluid_fourier_rows){from, in.stride}, (struct fluid_fourier_rows){to, out.stride},
                scratch);
        return;
    }
    take(t, in, from, scratch[0]);
    put(t, out,
        of_rows(t->fourier, (struct fluid_fourier_rows){scratch[0], LINES}, (struct fluid_fourier_rows){NULL, 0},
                scratch)
            .at,
        to);
}

void fluid_transform_pair_forward(const struct fluid_transform_pair *t, double *in_place) {
    for (int l = 0; l < t->in.lines; l += LINES) {
        const struct lines group = lines_from(t, l, t->in.stride, t->in.distance);
        double *q = in_place + (ptrdiff_t)l * group.distance;
        transform_lines(t, fluid_fourier_forward, group, q, group, q);
    }
}

void fluid_transform_pair_backward(const struct fluid_transform_pair *t, const double *from, double *to) {
    for (int l = 0; l < t->in.lines; l += LINES) {
        const struct lines group = lines_from(t, l, t->in.stride, t->in.distance);
        const struct lines out = lines_from(t, l, t->in.out_stride, t->in.out_distance);
        transform_lines(t, fluid_fourier_backward, group, (double *)(size_t)(from + (ptrdiff_t)l * group.distance), out,
                        to + (ptrdiff_t)l * out.distance);
    }
}
