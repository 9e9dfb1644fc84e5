/* Transforms two real lines at once as one complex line, for periodic, Neumann and Dirichlet ends. */
#include "fluid/poisson/transform_pair.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/threads.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SCRATCH = 4096 }; /* doubles that stay in the first-level cache with their transform */

struct fluid_transform_pair {
    struct fluid_transform_input in;
    int along;             /* 1: lines are contiguous (x); 0: neighbouring values belong to neighbouring lines (y, z) */
    int chunk;             /* number of lines transformed at once, even */
    int folded;            /* order of a line's values: even places forwards, then odd ones backwards */
    double odd;            /* sign of the odd places */
    double *cosine, *sine; /* [n/2 + 1] forward; backward is 2 cos, 2 sin for periodic lines, the same otherwise */
    double first, middle, back_middle; /* factors of coefficients 0 and n/2 */
    double back;                       /* backward over forward twiddles */
    double mirror;                     /* 1, or -1 for periodic lines: sign of the cosine for coefficient n-k */
    double *place, *value;             /* scratch of each thread: along [chunk][n], across [n][chunk] */
    size_t room;                       /* of a thread, in whole cache lines */
    fftw_plan forward, backward;
};

/* Index in v of value j of a line. */
static int folded_place(const struct fluid_transform_pair *t, int j) {
    if (!t->folded) return j;
    return j % 2 == 0 ? j / 2 : t->in.n - 1 - j / 2;
}

static int divisor_at_most(int of, int most) {
    int d = most < of ? most : of;
    while (d > 1 && of % d) d--;
    return d;
}

static void plan(struct fluid_transform_pair *t) {
    const int n = t->in.n, pairs = t->chunk / 2;
    const unsigned flags = FFTW_MEASURE;
    if (t->along) {
        const fftw_iodim line = {n, 1, 1}, many = {pairs, 2 * n, 2 * n};
        double *p = t->place, *v = t->value;
        t->forward = fftw_plan_guru_split_dft(1, &line, 1, &many, p, p + n, v, v + n, flags);
        t->backward = fftw_plan_guru_split_dft(1, &line, 1, &many, v + n, v, p + n, p, flags | FFTW_DESTROY_INPUT);
    } else {
        fftw_complex *p = (fftw_complex *)t->place;
        t->forward = fftw_plan_many_dft(1, &n, pairs, p, NULL, pairs, 1, p, NULL, pairs, 1, FFTW_FORWARD, flags);
        t->backward = fftw_plan_many_dft(1, &n, pairs, p, NULL, pairs, 1, p, NULL, pairs, 1, FFTW_BACKWARD, flags);
    }
}

struct fluid_transform_pair *fluid_transform_pair_new(const struct fluid_transform_input *in) {
    const int along = in->stride == 1 && in->distance >= in->n && in->n > 1, n = in->n;
    if (in->low != in->high || in->low == FLUID_END_FACE || in->lines % 2 || n < 2 || (!along && in->distance != 1))
        return NULL;
    ENSURE(!along || !in->out_stride || in->out_stride == 1, "values of a line written %d apart", in->out_stride);
    struct fluid_transform_pair *t = calloc(1, sizeof *t);
    t->in = *in;
    if (!in->out_stride) {
        t->in.out_stride = in->stride;
        t->in.out_distance = in->distance;
    }
    t->along = along;
    t->chunk = 2 * divisor_at_most(in->lines / 2, SCRATCH / 2 / n < 1 ? 1 : SCRATCH / 2 / n);
    const int periodic = in->low == FLUID_END_PERIODIC;
    t->folded = !periodic;
    t->odd = in->low == FLUID_END_DIRICHLET ? -1 : 1;
    t->first = periodic ? 1 : 2;
    t->middle = t->back_middle = periodic ? 1 : sqrt(2);
    t->back = periodic ? 2 : 1;
    t->mirror = periodic ? -1 : 1;
    t->cosine = memory_new(MEMORY_FLUID, (size_t)n + 2, sizeof(double));
    t->sine = t->cosine + n / 2 + 1;
    for (int k = 0; k <= n / 2; k++) {
        t->cosine[k] = periodic ? 0.5 : cos(0.5 * M_PI * k / n);
        t->sine[k] = periodic ? 0 : sin(0.5 * M_PI * k / n);
    }
    t->room = ((size_t)n * (size_t)t->chunk + 7) / 8 * 8;
    t->place = memory_new(MEMORY_FLUID, t->room * (size_t)threads_count(), sizeof(double));
    t->value = along ? memory_new(MEMORY_FLUID, t->room * (size_t)threads_count(), sizeof(double)) : t->place;
    plan(t);
    return t;
}

void fluid_transform_pair_free(struct fluid_transform_pair *t) {
    if (!t) return;
    fftw_destroy_plan(t->forward);
    fftw_destroy_plan(t->backward);
    if (t->value != t->place) memory_free(t->value);
    memory_free(t->place);
    memory_free(t->cosine);
    free(t);
}

/* Lines along memory: a and b are rows, coefficients run with k. */

static void fold_line(int n, double odd, const double *restrict q, double *restrict v) {
    for (int j = 0; j < n / 2; j++) v[j] = q[2 * j];
    if (n % 2) v[n / 2] = q[n - 1];
    for (int j = 0; j < n / 2; j++) v[n - 1 - j] = odd * q[2 * j + 1];
}

static void unfold_line(int n, double odd, const double *restrict v, double *restrict q) {
    for (int j = 0; j < n / 2; j++) {
        q[2 * j] = v[j];
        q[2 * j + 1] = odd * v[n - 1 - j];
    }
    if (n % 2) q[n - 1] = v[n / 2];
}

/* Z (re, im) -> coefficients of a and b; up = 1, or -1 with a, b pointing to their last value (Dirichlet). */
static inline __attribute__((always_inline)) void gather_line(const struct fluid_transform_pair *t, const int up,
                                                              const double *restrict re, const double *restrict im,
                                                              double *restrict a, double *restrict b) {
    const int n = t->in.n;
    const double *restrict cosine = t->cosine, *restrict sine = t->sine;
    const double mirror = t->mirror;
    a[0] = t->first * re[0];
    b[0] = t->first * im[0];
    for (int k = 1; k < (n + 1) / 2; k++) {
        const double c = cosine[k], s = sine[k], p = re[k] + re[n - k], q = im[k] - im[n - k], r = im[k] + im[n - k],
                     d = re[k] - re[n - k];
        a[up * k] = c * p + s * q;
        a[up * (n - k)] = s * p - mirror * c * q;
        b[up * k] = c * r - s * d;
        b[up * (n - k)] = s * r + mirror * c * d;
    }
    if (n % 2 == 0) {
        a[up * (n / 2)] = t->middle * re[n / 2];
        b[up * (n / 2)] = t->middle * im[n / 2];
    }
}

static inline __attribute__((always_inline)) void spread_line(const struct fluid_transform_pair *t, const int up,
                                                              const double *restrict a, const double *restrict b,
                                                              double *restrict re, double *restrict im) {
    const int n = t->in.n;
    const double *restrict cosine = t->cosine, *restrict sine = t->sine, back = t->back, mirror = t->mirror;
    re[0] = a[0];
    im[0] = b[0];
    for (int k = 1; k < (n + 1) / 2; k++) {
        const double c = back * cosine[k], s = back * sine[k];
        const double ar = c * a[up * k] + s * a[up * (n - k)], ai = s * a[up * k] - mirror * c * a[up * (n - k)];
        const double br = c * b[up * k] + s * b[up * (n - k)], bi = s * b[up * k] - mirror * c * b[up * (n - k)];
        re[k] = ar - bi;
        im[k] = ai + br;
        re[n - k] = ar + bi;
        im[n - k] = br - ai;
    }
    if (n % 2 == 0) {
        re[n / 2] = t->back_middle * a[up * (n / 2)];
        im[n / 2] = t->back_middle * b[up * (n / 2)];
    }
}

static void along_forward(const struct fluid_transform_pair *t, double *q) {
    const int n = t->in.n;
    double *const place = t->place + t->room * (size_t)threads_me(), *const value =
                                                                         t->value + t->room * (size_t)threads_me();
    for (int l = 0; l < t->chunk; l++) {
        if (t->folded)
            fold_line(n, t->odd, q + (ptrdiff_t)l * t->in.distance, place + l * n);
        else
            memcpy(place + l * n, q + (ptrdiff_t)l * t->in.distance, (size_t)n * sizeof *q);
    }
    fftw_execute_split_dft(t->forward, place, place + n, value, value + n);
    for (int l = 0; l < t->chunk; l += 2) {
        double *a = q + (ptrdiff_t)l * t->in.distance, *b = a + t->in.distance;
        const double *re = value + l * n, *im = re + n;
        if (t->odd > 0)
            gather_line(t, 1, re, im, a, b);
        else
            gather_line(t, -1, re, im, a + n - 1, b + n - 1);
    }
}

static void along_backward(const struct fluid_transform_pair *t, const double *q, double *to) {
    const int n = t->in.n;
    double *const place = t->place + t->room * (size_t)threads_me(), *const value =
                                                                         t->value + t->room * (size_t)threads_me();
    for (int l = 0; l < t->chunk; l += 2) {
        const double *a = q + (ptrdiff_t)l * t->in.distance, *b = a + t->in.distance;
        double *re = value + l * n, *im = re + n;
        if (t->odd > 0)
            spread_line(t, 1, a, b, re, im);
        else
            spread_line(t, -1, a + n - 1, b + n - 1, re, im);
    }
    fftw_execute_split_dft(t->backward, value + n, value, place + n, place);
    for (int l = 0; l < t->chunk; l++) {
        if (t->folded)
            unfold_line(n, t->odd, place + l * n, to + (ptrdiff_t)l * t->in.out_distance);
        else
            memcpy(to + (ptrdiff_t)l * t->in.out_distance, place + l * n, (size_t)n * sizeof *to);
    }
}

/* Lines across memory: a and b are neighbouring columns, every step is a loop over rows. */

static void copy_row(int count, double sign, const double *restrict from, double *restrict to) {
    for (int l = 0; l < count; l++) to[l] = sign * from[l];
}

/* Rows Z_k, Z_{n-k} -> coefficients k, n-k. */
static void gather_rows(int pairs, double c, double s, double cm, const double *restrict z, const double *restrict y,
                        double *restrict to, double *restrict to_mirror) {
    for (int l = 0; l < pairs; l++) {
        const double p = z[2 * l] + y[2 * l], q = z[2 * l + 1] - y[2 * l + 1];
        const double r = z[2 * l + 1] + y[2 * l + 1], d = z[2 * l] - y[2 * l];
        to[2 * l] = c * p + s * q;
        to[2 * l + 1] = c * r - s * d;
        to_mirror[2 * l] = s * p - cm * q;
        to_mirror[2 * l + 1] = s * r + cm * d;
    }
}

static void spread_rows(int pairs, double c, double s, double cm, const double *restrict from,
                        const double *restrict mirror, double *restrict z, double *restrict y) {
    for (int l = 0; l < pairs; l++) {
        const double ar = c * from[2 * l] + s * mirror[2 * l], ai = s * from[2 * l] - cm * mirror[2 * l];
        const double br = c * from[2 * l + 1] + s * mirror[2 * l + 1];
        const double bi = s * from[2 * l + 1] - cm * mirror[2 * l + 1];
        z[2 * l] = ar - bi;
        z[2 * l + 1] = ai + br;
        y[2 * l] = ar + bi;
        y[2 * l + 1] = br - ai;
    }
}

/* The row that holds coefficient k: Dirichlet lines count from their end. */
static ptrdiff_t row_of(const struct fluid_transform_pair *t, int k) {
    return (ptrdiff_t)(t->odd > 0 ? k : t->in.n - 1 - k) * t->in.stride;
}

static void across_forward(const struct fluid_transform_pair *t, double *q) {
    const int n = t->in.n, w = t->chunk;
    double *const place = t->place + t->room * (size_t)threads_me();
    for (int j = 0; j < n; j++)
        copy_row(w, t->folded && j % 2 ? t->odd : 1, q + (ptrdiff_t)j * t->in.stride, place + folded_place(t, j) * w);
    fftw_execute_dft(t->forward, (fftw_complex *)place, (fftw_complex *)place);
    copy_row(w, t->first, place, q + row_of(t, 0));
    for (int k = 1; k < (n + 1) / 2; k++)
        gather_rows(w / 2, t->cosine[k], t->sine[k], t->mirror * t->cosine[k], place + k * w, place + (n - k) * w,
                    q + row_of(t, k), q + row_of(t, n - k));
    if (n % 2 == 0) copy_row(w, t->middle, place + n / 2 * w, q + row_of(t, n / 2));
}

static void across_backward(const struct fluid_transform_pair *t, const double *q, double *to) {
    const int n = t->in.n, w = t->chunk;
    double *const place = t->place + t->room * (size_t)threads_me();
    copy_row(w, 1, q + row_of(t, 0), place);
    for (int k = 1; k < (n + 1) / 2; k++)
        spread_rows(w / 2, t->back * t->cosine[k], t->back * t->sine[k], t->mirror * t->back * t->cosine[k],
                    q + row_of(t, k), q + row_of(t, n - k), place + k * w, place + (n - k) * w);
    if (n % 2 == 0) copy_row(w, t->back_middle, q + row_of(t, n / 2), place + n / 2 * w);
    fftw_execute_dft(t->backward, (fftw_complex *)place, (fftw_complex *)place);
    for (int j = 0; j < n; j++)
        copy_row(w, t->folded && j % 2 ? t->odd : 1, place + folded_place(t, j) * w,
                 to + (ptrdiff_t)j * t->in.out_stride);
}

void fluid_transform_pair_forward(const struct fluid_transform_pair *t, double *q) {
    for (int l = 0; l < t->in.lines; l += t->chunk) {
        if (t->along)
            along_forward(t, q + (ptrdiff_t)l * t->in.distance);
        else
            across_forward(t, q + l);
    }
}

void fluid_transform_pair_backward(const struct fluid_transform_pair *t, const double *from, double *to) {
    for (int l = 0; l < t->in.lines; l += t->chunk) {
        if (t->along)
            along_backward(t, from + (ptrdiff_t)l * t->in.distance, to + (ptrdiff_t)l * t->in.out_distance);
        else
            across_backward(t, from + l, to + l);
    }
}
