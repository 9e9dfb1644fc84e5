/* Solves the Poisson or Helmholtz equation along z, column by column, with z divided over ranks. */
#include "fluid/poisson/column.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/threads.h"
#include "base/vec.h"
#include "fluid/poisson/column_ends.h"
#include "fluid/poisson/column_ranks.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Powers of r below the first are neglected; powers below the second are set to 0, so that none is denormal. */
static const double negligible = 1e-20, smallest = 1e-290;
enum {
    CHUNK = 64,     /* columns that neglect powers of r together */
    STREAM = 500000 /* values of y; with more, planes that are kept are stored past the caches */
};

struct fluid_column {
    struct fluid_column_input in;
    struct fluid_column_ranks *ranks;
    int low, m;      /* this rank's planes */
    int free_column; /* the column whose mean is free, or -1 */
    /* [columns] */
    double *r, *inverse;    /* r, 1/r */
    double *power;          /* r^(k+1) during the run up; q[0] during the run down */
    double *sum;            /* sum over k of r^(k+1) y[k] */
    double *reach, *end;    /* number of planes, from the first, over which a y below has an effect; r^reach */
    double *from_below;     /* y below times r^(k+1) */
    int *reaches;           /* [columns/CHUNK] the largest reach of a chunk */
    double *q[THREADS_MAX]; /* q of the planes computed last, one for each thread: plane k in q[(m - k) % threads] */
    double *line;           /* [n] a whole column */
};

static double *array(size_t count) { return memory_new(MEMORY_FLUID, count + 1, sizeof(double)); }

static void fill_columns(struct fluid_column *c, const double *lambda, double shift) {
    for (int i = 0; i < c->in.columns; i++) {
        const double theta = fluid_column_ends_theta(lambda[i] - shift, c->in.d);
        int reach = c->m;
        if (theta * reach > -log(negligible)) reach = (int)ceil(-log(negligible) / theta);
        c->r[i] = exp(-theta);
        c->inverse[i] = 1 / c->r[i];
        c->reach[i] = reach;
        c->end[i] = exp(-theta * reach);
        if (theta == 0 && c->in.free_mean) c->free_column = i;
        if (i % CHUNK == 0 || reach > c->reaches[i / CHUNK]) c->reaches[i / CHUNK] = reach;
    }
}

struct fluid_column *fluid_column_new(const struct fluid_column_input *in) {
    struct fluid_column *c = calloc(1, sizeof *c);
    const size_t columns = (size_t)in->columns;
    c->in = *in;
    c->in.lambda = NULL;
    c->free_column = -1;
    c->ranks = fluid_column_ranks_new(in);
    fluid_column_ranks_planes(c->ranks, &c->low, &c->m);
    double **of_columns[] = {&c->r, &c->inverse, &c->power, &c->sum, &c->reach, &c->end, &c->from_below};
    for (size_t i = 0; i < sizeof of_columns / sizeof *of_columns; i++) *of_columns[i] = array(columns);
    c->q[0] = c->power; /* no powers are needed on the way down */
    for (int t = 1; t < threads_count(); t++) c->q[t] = array(columns);
    c->line = array((size_t)in->n);
    c->reaches = calloc(columns / CHUNK + 1, sizeof *c->reaches);
    fluid_column_set(c, in->lambda, in->shift);
    return c;
}

void fluid_column_set(struct fluid_column *c, const double *lambda, double shift) {
    fill_columns(c, lambda, shift);
    fluid_column_ranks_set(c->ranks, lambda, shift);
}

void fluid_column_free(struct fluid_column *c) {
    if (!c) return;
    MEMORY_FREE(c->r, c->inverse, c->power, c->sum, c->reach, c->end, c->from_below, c->line);
    for (int t = 1; t < THREADS_MAX; t++) memory_free(c->q[t]);
    free(c->reaches);
    fluid_column_ranks_free(c->ranks);
    free(c);
}

static void up_first(int columns, double scale, const double *restrict r, double *restrict power, double *restrict sum,
                     double *restrict b) {
    for (int i = 0; i < columns; i++) {
        const double y = scale * b[i];
        b[i] = y;
        power[i] = r[i];
        sum[i] = r[i] * y;
    }
}

static void up(int columns, double scale, const double *restrict r, const double *restrict below,
               double *restrict power, double *restrict sum, double *restrict b) {
    for (int i = 0; i < columns; i++) {
        const double y = scale * b[i] + r[i] * below[i], p = r[i] * power[i] + smallest;
        b[i] = y;
        power[i] = p;
        sum[i] += p * y;
    }
}

/* Above the planes that the sum needs. */
static void up_alone(int columns, double scale, const double *restrict r, const double *restrict below,
                     double *restrict b) {
    for (int i = 0; i < columns; i++) b[i] = scale * b[i] + r[i] * below[i];
}

/* The end of a run of columns from i on that are in one chunk. */
static int end_of_chunk(int i, int to) {
    const int end = (i / CHUNK + 1) * CHUNK;
    return end < to ? end : to;
}

static void store(int columns, int stream, const double *restrict y, double *restrict copy) {
    if (!stream || columns % VEC_LANES || (uintptr_t)copy % sizeof(vec)) {
        memcpy(copy, y, (size_t)columns * sizeof *y);
        return;
    }
    for (int i = 0; i < columns; i += VEC_LANES) vec_stream(copy + i, vec_load(y + i));
}

void fluid_column_up(struct fluid_column *c, int k, int from, int to, const double *below, double *b, double *copy) {
    const int stream = (long)c->in.columns * c->m > STREAM;
    const double scale = c->in.scale * c->in.d * c->in.d;
    for (int i = from, end; i < to; i = end) {
        end = end_of_chunk(i, to);
        if (k == 0)
            up_first(end - i, scale, c->r + i, c->power + i, c->sum + i, b + i);
        else if (k < c->reaches[i / CHUNK])
            up(end - i, scale, c->r + i, below + i, c->power + i, c->sum + i, b + i);
        else
            up_alone(end - i, scale, c->r + i, below + i, b + i);
        if (copy) store(end - i, stream, b + i, copy + i);
    }
}

/* The column whose mean is free, r = 1: computes its differences q[k+1] - q[k] in line, for the whole column on every
 * rank that holds it. Returns q[n] of the solution with mean zero. */
static double free_line(struct fluid_column *c, const double *y, ptrdiff_t plane) {
    const int n = c->in.n, at = c->free_column;
    double *line = c->line, total = 0, slope = 0, sum = 0;
    for (int k = 0; k < n; k++) line[k] = 0;
    for (int k = 0; k < c->m && at >= 0; k++)
        line[c->low + k] = y[k * plane + at] - (k > 0 ? y[(k - 1) * plane + at] : 0);
    par_sum_array(line, n);
    if (at < 0) return 0;
    for (int k = 0; k < n; k++) total += line[k];
    for (int k = 0; k < n; k++) { /* b without its mean, summed up: q[k+1] - q[k] up to a constant */
        line[k] += (k > 0 ? line[k - 1] : 0) - total / n;
        slope += line[k] / n;
    }
    for (int k = 0; k < n; k++) {
        if (c->in.low == FLUID_END_PERIODIC) line[k] -= slope;
        sum += (k + 1) * line[k]; /* the sum of q is n q[n] less this */
    }
    return sum / n;
}

double fluid_column_free_end(struct fluid_column *c, const double *y, ptrdiff_t plane, int side) {
    double q = free_line(c, y, plane);
    for (int k = c->in.n - 1; k >= (side ? c->in.n - 1 : 0) && c->free_column >= 0; k--) q -= c->line[k];
    return q;
}

/* Every rank that holds the free column solves all of it; its differences replace y. */
static void solve_free(struct fluid_column *c, double *y, ptrdiff_t plane, double mean, double *q_above) {
    const int at = c->free_column;
    double *line = c->line, q = mean + free_line(c, y, plane);
    for (int k = c->in.n - 1; k >= c->low && at >= 0; k--) {
        if (k == c->low + c->m - 1) *q_above = q;
        if (k < c->low + c->m) y[(k - c->low) * plane + at] = line[k];
        q -= line[k];
    }
}

void fluid_column_couple(struct fluid_column *c, double *y, ptrdiff_t plane, double mean) {
    double q_above = 0;
    const double *const known[2] = {y + (c->m - 1) * plane, c->sum};
    double *const found[2] = {c->from_below, c->q[0]};
    fluid_column_ranks_couple(c->ranks, known, found);
    for (int i = 0; i < c->in.columns; i++) c->from_below[i] *= c->end[i];
    if (!c->in.free_mean) return;
    solve_free(c, y, plane, mean, &q_above);
    if (c->free_column < 0) return;
    c->from_below[c->free_column] = 0;
    c->q[0][c->free_column] = q_above;
}

/* q is that of the plane above, and becomes this plane's. */
static void down_in_place(int columns, double k, const double *restrict r, const double *restrict inverse,
                          const double *restrict reach, const double *restrict y, double *restrict from_below,
                          double *restrict q) {
    for (int i = 0; i < columns; i++) {
        const double below = from_below[i];
        const int felt = k < reach[i];
        q[i] = r[i] * (q[i] - (y[i] + (felt ? below : 0)));
        from_below[i] = felt ? below * inverse[i] : below;
    }
}

static void down(int columns, double k, const double *restrict r, const double *restrict inverse,
                 const double *restrict reach, const double *restrict y, double *restrict from_below,
                 const double *restrict above, double *restrict q) {
    for (int i = 0; i < columns; i++) {
        const double below = from_below[i];
        const int felt = k < reach[i];
        q[i] = r[i] * (above[i] - (y[i] + (felt ? below : 0)));
        from_below[i] = felt ? below * inverse[i] : below;
    }
}

/* The same for planes that a y below does not reach. */
static void down_alone_in_place(int columns, const double *restrict r, const double *restrict y, double *restrict q) {
    for (int i = 0; i < columns; i++) q[i] = r[i] * (q[i] - y[i]);
}

static void down_alone(int columns, const double *restrict r, const double *restrict y, const double *restrict above,
                       double *restrict q) {
    for (int i = 0; i < columns; i++) q[i] = r[i] * (above[i] - y[i]);
}

static double *found(const struct fluid_column *c, int k) {
    const int threads = threads_count();
    return c->q[(c->m - k + threads) % threads];
}

void fluid_column_down(struct fluid_column *c, int k, int from, int to, const double *y) {
    const double *above = found(c, k + 1);
    double *q = found(c, k);
    if (k >= c->m) return;
    for (int i = from, end; i < to; i = end) {
        end = end_of_chunk(i, to);
        const int count = end - i, felt = k < c->reaches[i / CHUNK];
        if (felt && above == q)
            down_in_place(count, k, c->r + i, c->inverse + i, c->reach + i, y + i, c->from_below + i, q + i);
        else if (felt)
            down(count, k, c->r + i, c->inverse + i, c->reach + i, y + i, c->from_below + i, above + i, q + i);
        else if (above == q)
            down_alone_in_place(count, c->r + i, y + i, q + i);
        else
            down_alone(count, c->r + i, y + i, above + i, q + i);
    }
}

const double *fluid_column_found(const struct fluid_column *c, int k) { return found(c, k); }
