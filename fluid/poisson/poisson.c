/* Direct Poisson and Helmholtz solver: transforms along x and y, recurrences along z.  (001: secs 3.4.3, 4.1.1) */
#include "fluid/poisson/poisson.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par_pencil.h"
#include "base/threads.h"
#include "fluid/poisson/column.h"

#include <math.h>
#include <stdlib.h>

enum { UNIT = 8 }; /* columns that threads share by, and a cache line */

struct fluid_poisson {
    struct fluid_poisson_input in;
    struct par_pencil *pencil;
    int x[3], y[3];               /* shapes of the pencils */
    struct fluid_transform *t[2]; /* of a plane of the x pencil, of a plane of the y pencil */
    struct fluid_column *column;  /* the one of the present shift */
    struct {
        double shift;
        struct fluid_column *column;
    } shifted[FLUID_POISSON_SHIFTS];
    double *lambda;            /* [columns] of the Laplacian along x and y; NULL without shifts */
    double *x_array, *y_array; /* planes of the x pencil and of the y pencil: one array if no transpose is needed;
                                * otherwise one plane more than the rank has */
    double *plane;             /* planes that are transformed: a few, used in turn, so that they stay in the cache */
    size_t capacity;           /* of one of them */
    double *sum[2]; /* of the right-hand side where the mean is free: [m_x] over y and z, transformed in x; [n_y] over x
                     * and z, transformed in y, on the ranks that hold these modes */
    double inverse_scale; /* 1 / (scale of the transforms) */
    int whole;            /* with a transpose: y_array is filled and transformed, and the run up its columns is done */
};

static double *eigenvalues(const struct fluid_poisson_input *in, int d) {
    double *lambda = memory_new(MEMORY_FLUID, (size_t)in->n[d], sizeof *lambda);
    fluid_transform_eigenvalues(in->n[d], in->d[d], in->end[d][0], in->end[d][1], lambda);
    return lambda;
}

static int free_mean(const struct fluid_poisson_input *in) {
    if (in->shifts > 0) return 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (in->end[d][side] == FLUID_END_DIRICHLET) return 0;
    return 1;
}

static size_t area(const int shape[3]) { return (size_t)shape[0] * (size_t)shape[1]; }

static size_t rounded_up(size_t count) { return (count + UNIT - 1) / UNIT * UNIT; }

static void plan(struct fluid_poisson *p) {
    const struct fluid_poisson_input *in = &p->in;
    const int *x = p->x, *y = p->y;
    const struct fluid_transform_input inputs[2] = {
        {.n = x[0], .lines = x[1], .stride = 1, .distance = x[0], .out_stride = 1, .out_distance = (int)in->row},
        {.n = y[1], .lines = y[0], .stride = y[0], .distance = 1, .out_stride = y[0], .out_distance = 1}};
    p->inverse_scale = 1;
    for (int d = 0; d < 2; d++) {
        struct fluid_transform_input t = inputs[d];
        t.low = in->end[d][0];
        t.high = in->end[d][1];
        p->t[d] = fluid_transform_new(&t);
        p->inverse_scale /= fluid_transform_scale(t.n, t.low, t.high);
    }
}

/* [columns] of this rank. */
static double *new_lambda(const struct fluid_poisson *p) {
    const int *m = p->y, low = par_pencil_low(p->pencil);
    double *x = eigenvalues(&p->in, 0), *y = eigenvalues(&p->in, 1);
    double *lambda = memory_new(MEMORY_FLUID, area(m), sizeof *lambda);
    for (int j = 0; j < m[1]; j++)
        for (int i = 0; i < m[0]; i++) lambda[j * m[0] + i] = x[low + i] + y[j];
    MEMORY_FREE(x, y);
    return lambda;
}

static struct fluid_column *new_columns(const struct fluid_poisson *p, const double *lambda, double shift) {
    const int *m = p->y;
    const struct fluid_column_input in = {.n = p->in.n[2],
                                          .ranks = {1, p->in.ranks[1], p->in.ranks[2]},
                                          .cut = p->in.cut[2],
                                          .d = p->in.d[2],
                                          .scale = p->inverse_scale,
                                          .low = p->in.end[2][0],
                                          .high = p->in.end[2][1],
                                          .columns = m[0] * m[1],
                                          .lambda = lambda,
                                          .work = p->in.work,
                                          .capacity = p->in.capacity,
                                          .shift = shift,
                                          .free_mean = free_mean(&p->in)};
    return fluid_column_new(&in);
}

/* Makes the columns of the Laplacian, or those of as many shifts as asked for, with a placeholder for each shift. */
static void add_columns(struct fluid_poisson *p) {
    const double some = 1 / (p->in.d[2] * p->in.d[2]);
    double *lambda = new_lambda(p);
    ENSURE(p->in.shifts <= FLUID_POISSON_SHIFTS, "%d shifts of one solver", p->in.shifts);
    for (int s = 0; s < p->in.shifts; s++) {
        p->shifted[s].shift = some;
        p->shifted[s].column = new_columns(p, lambda, some);
    }
    if (p->in.shifts > 0) {
        p->lambda = lambda;
        p->column = p->shifted[0].column;
        return;
    }
    p->column = new_columns(p, lambda, 0);
    memory_free(lambda);
}

void fluid_poisson_shift(struct fluid_poisson *p, int which, double shift) {
    ENSURE(which < p->in.shifts && shift > 0, "shift %d of %d, %g 1/m2", which, p->in.shifts, shift);
    p->column = p->shifted[which].column;
    if (p->shifted[which].shift != shift) fluid_column_set(p->column, p->lambda, shift);
    p->shifted[which].shift = shift;
}

/* Planes that the forward transforms use in turn: the threads' own, and the one before; with several threads, one
 * thread may still run up these while another one fills its next plane. */
static int planes_in_turn(void) { return threads_count() > 1 ? 3 * threads_count() : 2; }

static double *plane_of(const struct fluid_poisson *p, int k) {
    return p->plane + (size_t)(k % planes_in_turn()) * p->capacity;
}

struct fluid_poisson *fluid_poisson_new(const struct fluid_poisson_input *in) {
    struct fluid_poisson *p = calloc(1, sizeof *p);
    const struct par_pencil_input grid = {.n = {in->n[0], in->n[1], in->n[2]},
                                          .ranks = {1, in->ranks[1], in->ranks[2]},
                                          .cut = {NULL, in->cut[1], in->cut[2]},
                                          .extra = 1};
    p->in = *in;
    p->pencil = par_pencil_new(&grid);
    par_pencil_shape(p->pencil, p->x, p->y);
    const size_t planes = (size_t)p->x[2] + (par_pencil_same(p->pencil) ? 0 : 1);
    p->x_array = memory_new_work(MEMORY_FLUID, planes * area(p->x));
    p->y_array = par_pencil_same(p->pencil) ? p->x_array : memory_new_work(MEMORY_FLUID, planes * area(p->y));
    p->capacity = rounded_up(area(p->x));
    p->plane = memory_new(MEMORY_FLUID, (size_t)planes_in_turn() * p->capacity,
                          sizeof(double)); /* rows of a side's faces stay zero */
    for (int d = 0; d < 2 && free_mean(in); d++) p->sum[d] = memory_new(MEMORY_FLUID, (size_t)p->y[d], sizeof(double));
    plan(p);
    add_columns(p);
    return p;
}

void fluid_poisson_free(struct fluid_poisson *p) {
    if (!p) return;
    for (int d = 0; d < 2; d++) {
        fluid_transform_free(p->t[d]);
        memory_free(p->sum[d]);
    }
    if (p->in.shifts == 0) fluid_column_free(p->column);
    for (int s = 0; s < p->in.shifts; s++) fluid_column_free(p->shifted[s].column);
    memory_free(p->lambda);
    if (p->y_array != p->x_array) memory_free(p->y_array);
    MEMORY_FREE(p->x_array, p->plane);
    par_pencil_free(p->pencil);
    free(p);
}

static double *y_plane(const struct fluid_poisson *p, int k) { return p->y_array + (size_t)k * area(p->y); }

double *fluid_poisson_plane(const struct fluid_poisson *p, int k) { return p->x_array + (size_t)k * area(p->x); }

static int is_same(const struct fluid_poisson *p) { return p->y_array == p->x_array; }

/* Adds plane k to the sums of the modes without variation in y and of those without variation in x, of the columns from
 * .. to-1. */
static void add_up(struct fluid_poisson *p, int k, int from, int to, const double *b) {
    for (int d = 0; d < 2; d++) {
        const int stride = d == 0 ? 1 : p->y[0];
        const int first = (from + stride - 1) / stride, end = (to + stride - 1) / stride;
        for (int i = first; p->sum[d] && i < p->y[d] && i < end; i++)
            p->sum[d][i] = (k > 0 ? p->sum[d][i] : 0) + b[i * stride];
    }
}

/* Where plane k is transformed along y, and run up. */
static double *forward_plane(const struct fluid_poisson *p, int k) {
    return is_same(p) ? plane_of(p, k) : y_plane(p, k);
}

/* Threads transform a plane each; then each runs up its part of these planes' columns. */
struct forward {
    struct fluid_poisson *p;
    void (*fill)(void *data, int k, double *plane); /* NULL: y alone */
    void *data;
};

static void forward(int thread, void *data) {
    const struct forward *f = data;
    struct fluid_poisson *p = f->p;
    const int threads = threads_count(), has_y = !f->fill || is_same(p);
    int from, to;
    threads_share((int)area(p->y), UNIT, thread, &from, &to);
    for (int first = 0; first < p->x[2]; first += threads) {
        const int end = first + threads < p->x[2] ? first + threads : p->x[2], k = first + thread;
        if (k < end && f->fill) {
            double *plane = is_same(p) ? plane_of(p, k) : fluid_poisson_plane(p, k);
            f->fill(f->data, k, plane);
            fluid_transform_forward(p->t[0], plane);
        }
        if (!has_y) continue;
        if (k < end) fluid_transform_forward(p->t[1], forward_plane(p, k));
        threads_wait();
        for (int i = first; i < end; i++) {
            add_up(p, i, from, to, forward_plane(p, i));
            fluid_column_up(p->column, i, from, to, i > 0 ? forward_plane(p, i - 1) : NULL, forward_plane(p, i),
                            is_same(p) ? y_plane(p, i) : NULL);
        }
    }
}

void fluid_poisson_forward(struct fluid_poisson *p, void (*fill)(void *data, int k, double *plane), void *data) {
    threads_run(forward, &(struct forward){p, fill, data});
}

/* The transforms in y and the run up, where they have to wait for the transpose. */
static void rest_forward(struct fluid_poisson *p) {
    if (is_same(p) || p->whole) return;
    p->whole = 1;
    par_pencil_forward(p->pencil, p->x[2], p->x_array, p->y_array);
    threads_run(forward, &(struct forward){p, NULL, NULL});
}

/* Threads run down their parts of the columns of some planes; then each transforms one of them. */
struct backward {
    struct fluid_poisson *p;
    const struct fluid_poisson_target *to; /* NULL: y alone, in place */
};

static void backward(int thread, void *data) {
    const struct backward *b = data;
    struct fluid_poisson *p = b->p;
    const int threads = threads_count(), has_y = !b->to || is_same(p);
    int from, to;
    threads_share((int)area(p->y), UNIT, thread, &from, &to);
    for (int first = p->x[2]; first >= 0; first -= threads) {
        const int k = first - thread;
        for (int i = first; has_y && i >= 0 && i > first - threads; i--)
            fluid_column_down(p->column, i, from, to, y_plane(p, i));
        threads_wait();
        if (k >= 0 && !b->to) fluid_transform_backward(p->t[1], fluid_column_found(p->column, k), y_plane(p, k));
        if (k >= 0 && b->to) {
            const double *plane = fluid_poisson_plane(p, k);
            if (has_y) {
                double *local = plane_of(p, thread);
                fluid_transform_backward(p->t[1], fluid_column_found(p->column, k), local);
                plane = local;
            }
            fluid_transform_backward(p->t[0], plane, b->to->place(b->to->data, k));
        }
        threads_wait();
        if (k >= 0 && b->to && b->to->use) b->to->use(b->to->data, k);
    }
}

void fluid_poisson_solve(struct fluid_poisson *p, double mean) {
    rest_forward(p);
    fluid_column_couple(p->column, p->y_array, (ptrdiff_t)area(p->y), mean);
    p->whole = 0;
    if (is_same(p)) return;
    threads_run(backward, &(struct backward){p, NULL});
    par_pencil_backward(p->pencil, p->x[2] + 1, p->y_array, p->x_array);
}

void fluid_poisson_backward(struct fluid_poisson *p, const struct fluid_poisson_target *to) {
    threads_run(backward, &(struct backward){p, to});
}

/* Summed over the other two directions, the equation of a mode cos(pi k (i+1/2)/n) reads lambda times the sum of q =
 * the sum of the right-hand side; along z the sums are a column. */
double fluid_poisson_section_mean(struct fluid_poisson *p, int direction, int side) {
    const int n = p->in.n[direction], i = side ? n - 1 : 0, x_low = par_pencil_low(p->pencil);
    const int low = direction == 0 ? x_low : 0;
    double mean = 0;
    ENSURE(p->sum[0] && p->in.end[direction][side] == FLUID_END_NEUMANN, "no free level at %c side %d",
           "xyz"[direction], side);
    rest_forward(p);
    if (direction == 2)
        return fluid_column_free_end(p->column, p->y_array, (ptrdiff_t)area(p->y), side) / p->in.ranks[2];
    if (direction == 1 && x_low > 0) return 0;
    for (int k = low == 0 ? 1 : 0; k < p->y[direction]; k++) {
        const double half = 0.5 * M_PI * (low + k) / n, s = 2 * sin(half) / p->in.d[direction];
        mean -= 2 * cos(half * (2 * i + 1)) * p->sum[direction][k] / (s * s);
    }
    return mean * p->inverse_scale / p->in.n[2];
}
