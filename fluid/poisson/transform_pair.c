/* Transforms eight real lines at once as four complex ones, for periodic, Neumann and Dirichlet ends. */
#include "fluid/poisson/transform_pair.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/threads.h"
#include "base/vec_shuffle.h"
#include "fluid/poisson/fourier.h"

#include <math.h>
#include <stdlib.h>

enum {
    LINES = FLUID_FOURIER_VALUE, /* at once: a value of a complex line is that of lines l and l + HALF */
    HALF = FLUID_FOURIER_LINES,
    APART = 9 * LINES /* between two arrays of scratch, so that their values do not share sets of the cache */
};

struct fluid_transform_pair {
    struct fluid_transform_input in;
    int along;             /* 1: lines are contiguous (x); 0: neighbouring values belong to neighbouring lines (y, z) */
    int *place, *same;     /* [n] where value j of a line is in v; j itself */
    double odd;            /* sign of the odd places */
    double *cosine, *sine; /* [n/2 + 1] forward; backward is 2 cos, 2 sin for periodic lines, the same otherwise */
    double first, middle, back_middle; /* factors of coefficients 0 and n/2 */
    double back;                       /* backward over forward twiddles */
    double mirror;                     /* 1, or -1 for periodic lines: sign of the cosine for coefficient n-k */
    struct fluid_fourier *fourier;
    double *scratch; /* of each thread, two arrays of [n][LINES] */
    size_t room;     /* of a thread */
};

static int is_periodic(const struct fluid_transform_pair *t) { return t->in.low == FLUID_END_PERIODIC; }

/* Even places forwards, then odd ones backwards. */
static int folded(int n, int j) { return j % 2 == 0 ? j / 2 : n - 1 - j / 2; }

static void fill_tables(struct fluid_transform_pair *t) {
    const int n = t->in.n, periodic = is_periodic(t);
    t->place = calloc(2 * (size_t)n, sizeof *t->place);
    t->same = t->place + n;
    for (int j = 0; j < n; j++) {
        t->same[j] = j;
        t->place[j] = periodic ? j : folded(n, j);
    }
    t->cosine = memory_new(MEMORY_FLUID, (size_t)n + 2, sizeof(double));
    t->sine = t->cosine + n / 2 + 1;
    for (int k = 0; k <= n / 2; k++) {
        t->cosine[k] = periodic ? 0.5 : cos(0.5 * M_PI * k / n);
        t->sine[k] = periodic ? 0 : sin(0.5 * M_PI * k / n);
    }
}

struct fluid_transform_pair *fluid_transform_pair_new(const struct fluid_transform_input *in) {
    const int along = in->stride == 1 && in->distance >= in->n && in->n > 1, n = in->n;
    if (in->low != in->high || in->low == FLUID_END_FACE || (!along && in->distance != 1)) return NULL;
    ENSURE(!along || !in->out_stride || in->out_stride == 1, "values of a line written %d apart", in->out_stride);
    struct fluid_fourier *fourier = fluid_fourier_new(n);
    if (!fourier) return NULL;
    struct fluid_transform_pair *t = calloc(1, sizeof *t);
    t->in = *in;
    if (!in->out_stride) {
        t->in.out_stride = in->stride;
        t->in.out_distance = in->distance;
    }
    t->along = along;
    t->fourier = fourier;
    const int periodic = is_periodic(t);
    t->odd = in->low == FLUID_END_DIRICHLET ? -1 : 1;
    t->first = periodic ? 1 : 2;
    t->middle = t->back_middle = periodic ? 1 : sqrt(2);
    t->back = periodic ? 2 : 1;
    t->mirror = periodic ? -1 : 1;
    fill_tables(t);
    t->room = 2 * ((size_t)n * LINES + APART);
    t->scratch = memory_new(MEMORY_FLUID, t->room * (size_t)threads_count(), sizeof(double));
    return t;
}

void fluid_transform_pair_free(struct fluid_transform_pair *t) {
    if (!t) return;
    fluid_fourier_free(t->fourier);
    memory_free(t->scratch);
    memory_free(t->cosine);
    free(t->place);
    free(t);
}

/* How lines are stored in v [n][LINES]: value j is v[place[j]] times factor[j % 2]. */
struct order {
    const int *place;
    vec factor[2];
};

/* Lines in the order of the Fourier transform. The inverse transform is the forward one of conjugate values: the
 * imaginary parts, which are the second half of the lines, have the opposite sign. */
static struct order folded_order(const struct fluid_transform_pair *t, double sign) {
    const vec one = {1, 1, 1, 1, sign, sign, sign, sign};
    return (struct order){t->place, {one, (is_periodic(t) ? 1 : t->odd) * one}};
}

static struct order plain_order(const struct fluid_transform_pair *t) {
    return (struct order){t->same, {vec_set(1), vec_set(1)}};
}

/* Where the lines of a call are. */
struct lines {
    int count, stride, distance;
};

/* Reads up to LINES lines; those that are missing repeat the last one. */
static void take(const struct fluid_transform_pair *t, struct lines of, const struct order *order,
                 const double *restrict q, double *restrict v) {
    const int n = t->in.n, whole = t->along ? n / LINES * LINES : of.count == LINES ? n : 0;
    const double *line[LINES];
    for (int l = 0; l < LINES; l++) line[l] = q + (ptrdiff_t)(l < of.count ? l : of.count - 1) * of.distance;
    for (int j = 0; j < whole && !t->along; j++)
        vec_store(v + order->place[j] * LINES, order->factor[j % 2] * vec_load(q + (ptrdiff_t)j * of.stride));
    for (int j = 0; j < whole && t->along; j += LINES) {
        vec a[LINES];
        for (int l = 0; l < LINES; l++) a[l] = vec_load(line[l] + j);
        vec_shuffle_transpose(a);
        for (int i = 0; i < LINES; i++) vec_store(v + order->place[j + i] * LINES, order->factor[i % 2] * a[i]);
    }
    for (int j = whole; j < n; j++)
        for (int l = 0; l < LINES; l++)
            v[order->place[j] * LINES + l] = order->factor[j % 2][l] * line[l][(ptrdiff_t)j * of.stride];
}

/* The reverse. */
static void put(const struct fluid_transform_pair *t, struct lines of, const struct order *order,
                const double *restrict v, double *restrict q) {
    const int n = t->in.n, full = of.count == LINES, whole = !full ? 0 : t->along ? n / LINES * LINES : n;
    for (int j = 0; j < whole && !t->along; j++)
        vec_store(q + (ptrdiff_t)j * of.stride, order->factor[j % 2] * vec_load(v + order->place[j] * LINES));
    for (int j = 0; j < whole && t->along; j += LINES) {
        vec a[LINES];
        for (int i = 0; i < LINES; i++) a[i] = order->factor[i % 2] * vec_load(v + order->place[j + i] * LINES);
        vec_shuffle_transpose(a);
        for (int l = 0; l < LINES; l++) vec_store(q + (ptrdiff_t)l * of.distance + j, a[l]);
    }
    for (int j = whole; j < n; j++)
        for (int l = 0; l < of.count; l++)
            q[(ptrdiff_t)l * of.distance + (ptrdiff_t)j * of.stride] =
                order->factor[j % 2][l] * v[order->place[j] * LINES + l];
}

/* Coefficients k and n-k of a pair, and where they are: Dirichlet lines count from their end. */
static ptrdiff_t row_of(const struct fluid_transform_pair *t, int k, ptrdiff_t stride) {
    return (t->odd > 0 ? k : t->in.n - 1 - k) * stride;
}

/* Z -> coefficients, in rows of LINES. */
static void gather(const struct fluid_transform_pair *t, const double *restrict z, ptrdiff_t stride,
                   double *restrict to) {
    const int n = t->in.n;
    vec_store(to + row_of(t, 0, stride), t->first * vec_load(z));
    for (int k = 1; k < (n + 1) / 2; k++)
        for (int l = 0; l < HALF; l += VEC4_LANES) {
            const double *here = z + k * LINES + l, *there = z + (n - k) * LINES + l;
            double *low = to + row_of(t, k, stride) + l, *high = to + row_of(t, n - k, stride) + l;
            const double c = t->cosine[k], s = t->sine[k], cm = t->mirror * c;
            const vec4 re = vec4_load(here), im = vec4_load(here + HALF);
            const vec4 re_there = vec4_load(there), im_there = vec4_load(there + HALF);
            const vec4 p = re + re_there, q = im - im_there, r = im + im_there, d = re - re_there;
            vec4_store(low, c * p + s * q);
            vec4_store(low + HALF, c * r - s * d);
            vec4_store(high, s * p - cm * q);
            vec4_store(high + HALF, s * r + cm * d);
        }
    if (n % 2 == 0) vec_store(to + row_of(t, n / 2, stride), t->middle * vec_load(z + n / 2 * LINES));
}

/* Coefficients -> the conjugate of Z. */
static void spread(const struct fluid_transform_pair *t, const double *restrict from, ptrdiff_t stride,
                   double *restrict z) {
    const int n = t->in.n;
    const vec conjugate = {1, 1, 1, 1, -1, -1, -1, -1};
    vec_store(z, conjugate * vec_load(from + row_of(t, 0, stride)));
    for (int k = 1; k < (n + 1) / 2; k++)
        for (int l = 0; l < HALF; l += VEC4_LANES) {
            const double *low = from + row_of(t, k, stride) + l, *high = from + row_of(t, n - k, stride) + l;
            double *here = z + k * LINES + l, *there = z + (n - k) * LINES + l;
            const double c = t->back * t->cosine[k], s = t->back * t->sine[k], cm = t->mirror * c;
            const vec4 a = vec4_load(low), b = vec4_load(low + HALF);
            const vec4 a_high = vec4_load(high), b_high = vec4_load(high + HALF);
            const vec4 ar = c * a + s * a_high, ai = s * a - cm * a_high, br = c * b + s * b_high,
                       bi = s * b - cm * b_high;
            vec4_store(here, ar - bi);
            vec4_store(here + HALF, -(ai + br));
            vec4_store(there, ar + bi);
            vec4_store(there + HALF, ai - br);
        }
    if (n % 2 == 0)
        vec_store(z + n / 2 * LINES, t->back_middle * conjugate * vec_load(from + row_of(t, n / 2, stride)));
}

/* Whether rows of coefficients can be read and written where they are. */
static int in_rows(const struct fluid_transform_pair *t, struct lines of) { return !t->along && of.count == LINES; }

static struct lines lines_from(const struct fluid_transform_pair *t, int first, int stride, int distance) {
    const int left = t->in.lines - first;
    return (struct lines){left < LINES ? left : LINES, stride, distance};
}

static double *scratch_of(const struct fluid_transform_pair *t, int which) {
    return t->scratch + (size_t)threads_me() * t->room + (size_t)which * t->room / 2;
}

void fluid_transform_pair_forward(const struct fluid_transform_pair *t, double *in_place) {
    const struct order order = folded_order(t, 1), plain = plain_order(t);
    double *const a = scratch_of(t, 0), *const b = scratch_of(t, 1);
    for (int l = 0; l < t->in.lines; l += LINES) {
        const struct lines of = lines_from(t, l, t->in.stride, t->in.distance);
        double *q = in_place + (ptrdiff_t)l * t->in.distance;
        take(t, of, &order, q, a);
        double *z = fluid_fourier_forward(t->fourier, a, b), *rows = z == a ? b : a;
        if (in_rows(t, of)) {
            gather(t, z, of.stride, q);
        } else {
            gather(t, z, LINES, rows);
            put(t, of, &plain, rows, q);
        }
    }
}

void fluid_transform_pair_backward(const struct fluid_transform_pair *t, const double *from, double *to) {
    const struct order order = folded_order(t, -1), plain = plain_order(t);
    double *const a = scratch_of(t, 0), *const b = scratch_of(t, 1);
    for (int l = 0; l < t->in.lines; l += LINES) {
        const struct lines of = lines_from(t, l, t->in.stride, t->in.distance);
        const struct lines out = lines_from(t, l, t->in.out_stride, t->in.out_distance);
        const double *q = from + (ptrdiff_t)l * of.distance;
        if (in_rows(t, of)) {
            spread(t, q, of.stride, b);
        } else {
            take(t, of, &plain, q, a);
            spread(t, a, LINES, b);
        }
        put(t, out, &order, fluid_fourier_forward(t->fourier, b, a), to + (ptrdiff_t)l * out.distance);
    }
}
