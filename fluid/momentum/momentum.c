/* Explicit stage of the momentum equation in one pass over the grid.  (001: eqs 3.70, 3.74) */
#include "fluid/momentum/momentum.h"
#include "base/threads.h"
#include "base/vec_shuffle.h"
#include "fluid/momentum/flux.h"

#include <string.h>

enum {
    GROUP = 16384, /* cells of a group of planes whose divergence is taken while they are in the cache */
    BLOCK = 8192,  /* cells of a block of rows, if a plane is larger than a group: the values read of three planes, and
                    * the  fluxes along z that are stored for the next plane, fit a core's own cache */
    STREAM = 500000, /* cells of an array; with more, none of the ten arrays stays in a rank's share of the last-level
                      * cache */
    AHEAD = 1,       /* prefetch distance, rows */
    WAITING = 3      /* three components, stored as a vec of one after a vec of another */
};

struct pass {
    const struct fluid_momentum_stage *stage;
    const double *q[3], *p;
    double *predicted[3], *rate[3];
    ptrdiff_t shift; /* of the place of a cell in predicted, in cells */
    struct flux_factors factors;
    double pressure[3], constant[3]; /* c/(rho d), c source */
    ptrdiff_t cells;                 /* of a row, in whole vecs */
    int rows;                        /* of a block */
    double *z,
        *y; /* stored fluxes, m/s2: along z [rows][cells/VEC_LANES][3][VEC_LANES]; along y, of one row for each plane */
    double *nowhere[2]; /* [cells] target for faces that this equation does not advance */
    int goes_on;        /* 1: z holds the fluxes before the first plane */
};

static ptrdiff_t row_cells(const struct fluid_grid *g) { return (g->m[0] + VEC_LANES - 1) / VEC_LANES * VEC_LANES; }

/* A plane of a group is one block, whose fluxes along z are kept from group to group. Other planes have blocks of
 * about as many rows each. */
static int block_rows(const struct fluid_grid *g) {
    if (row_cells(g) * g->m[1] <= GROUP) return g->m[1];
    const int rows = (int)(BLOCK / row_cells(g)) > 4 ? (int)(BLOCK / row_cells(g)) : 4;
    const int blocks = (g->m[1] + rows - 1) / rows;
    return (g->m[1] + blocks - 1) / blocks;
}

static int parts(const struct fluid_grid *g) { return threads_count() < g->m[2] ? threads_count() : g->m[2]; }

/* Fluxes along z, and two rows that are written but never read; with several threads also the top plane, in whole cache
 * lines. */
static size_t thread_work(const struct fluid_grid *g) {
    const size_t rows = (size_t)row_cells(g) * (size_t)(WAITING * block_rows(g) + 2);
    return rows + (parts(g) > 1 ? 3 * (size_t)g->plane : 0);
}

size_t fluid_momentum_work(const struct fluid_grid *g) {
    return (size_t)row_cells(g) * (size_t)(WAITING * g->m[2]) + (size_t)parts(g) * thread_work(g);
}

/* Computes the fluxes along y through the low faces of the row that starts at n; wait_z: those along z. */
static void wait_y(const struct pass *s, ptrdiff_t n, double *y) {
    const struct fluid_grid *g = s->stage->grid;
    for (ptrdiff_t i = n - g->row, end = i + s->cells; i < end; i += VEC_LANES, y += WAITING * VEC_LANES) {
        const struct flux f = fluid_flux_at(&s->factors, g->row, g->plane, s->q[0] + i, s->q[1] + i, s->q[2] + i);
        vec_store(y, f.uy);
        vec_store(y + VEC_LANES, f.vy);
        vec_store(y + 2 * VEC_LANES, f.wy);
    }
}

static void wait_z(const struct pass *s, ptrdiff_t n, double *z) {
    const struct fluid_grid *g = s->stage->grid;
    for (ptrdiff_t i = n - g->plane, end = i + s->cells; i < end; i += VEC_LANES, z += WAITING * VEC_LANES) {
        const struct flux f = fluid_flux_at(&s->factors, g->row, g->plane, s->q[0] + i, s->q[1] + i, s->q[2] + i);
        vec_store(z, f.uz);
        vec_store(z + VEC_LANES, f.vz);
        vec_store(z + 2 * VEC_LANES, f.wz);
    }
}

/* Replaces the stored flux by the new one; returns new minus stored. */
static inline __attribute__((always_inline)) vec gain(vec flux, double *waiting) {
    const vec before = vec_load(waiting);
    vec_store(waiting, flux);
    return flux - before;
}

/* Properties of a stage that are constants when its loop is compiled. */
struct kind {
    int with_old, store_rate;
    int stream; /* non-temporal stores: results bypass the caches, unless they replace values that were read */
    int in_place;
};

static inline __attribute__((always_inline)) void put(int stream, double *to, vec v) {
    if (stream)
        vec_stream(to, v);
    else
        vec_store(to, v);
}

/* Prefetches cache lines of a later row that no earlier load has touched: of q and p one plane behind it, and of R. */
static inline __attribute__((always_inline)) void ask_ahead(const struct pass *s, ptrdiff_t n, const struct kind kind,
                                                            double *const rate[3], ptrdiff_t i) {
    const ptrdiff_t row = AHEAD * s->stage->grid->row, behind = n + i + row + s->stage->grid->plane;
    for (int c = 0; c < 3; c++) {
        __builtin_prefetch(s->q[c] + behind);
        if (kind.with_old) __builtin_prefetch(rate[c] + i + row);
    }
    __builtin_prefetch(s->p + behind);
}

/* Factors of the sum of a component. */
struct sum {
    double a, b, pressure, constant;
};

static inline __attribute__((always_inline)) void finish(const struct sum s, const struct kind kind, vec now, vec q,
                                                         vec gradient, double *predicted, double *rate) {
    vec next = q + s.a * now + (s.constant - s.pressure * gradient);
    if (kind.with_old) next += s.b * vec_load(rate);
    put(kind.stream && !kind.in_place, predicted, next);
    if (kind.store_rate) put(kind.stream && !kind.with_old, rate, now);
}

/* The row that starts at n. y, z: stored fluxes; predicted, rate: output of each component. */
static inline __attribute__((always_inline)) void predict_row(const struct pass *s, const struct kind kind, ptrdiff_t n,
                                                              double *y, double *z, double *const predicted[3],
                                                              double *const rate[3]) {
    const ptrdiff_t row = s->stage->grid->row, plane = s->stage->grid->plane, cells = s->cells;
    const double *u = s->q[0] + n, *v = s->q[1] + n, *w = s->q[2] + n, *p = s->p + n;
    double *const pu = predicted[0], *const pv = predicted[1], *const pw = predicted[2];
    double *const ru = rate[0], *const rv = rate[1], *const rw = rate[2];
    const struct flux_factors factors = s->factors;
    struct sum sum[3];
    for (int c = 0; c < 3; c++) sum[c] = (struct sum){s->stage->a, s->stage->b, s->pressure[c], s->constant[c]};
    struct flux f = fluid_flux_at(&factors, row, plane, u - VEC_LANES, v - VEC_LANES, w - VEC_LANES); /* only its last
                                                                                                       * lane is used */
    vec ux = f.ux, vx = f.vx, wx = f.wx;
    vec u0 = vec_load(u), v0 = vec_load(v), w0 = vec_load(w), p0 = vec_load(p);
    for (ptrdiff_t i = 0; i < cells; i += VEC_LANES, y += WAITING * VEC_LANES, z += WAITING * VEC_LANES) {
        ask_ahead(s, n, kind, rate, i);
        const ptrdiff_t next = i + VEC_LANES;
        const vec u1 = vec_load(u + next), v1 = vec_load(v + next), w1 = vec_load(w + next), p1 = vec_load(p + next);
        f = fluid_flux_through(&factors, fluid_flux_load(row, plane, u + i, u0, vec_shuffle_after(u0, u1)),
                               fluid_flux_load(row, plane, v + i, v0, vec_shuffle_after(v0, v1)),
                               fluid_flux_load(row, plane, w + i, w0, vec_shuffle_after(w0, w1)));
        const vec du = f.ux - vec_before(ux, f.ux) + gain(f.uy, y) + gain(f.uz, z);
        const vec dv = f.vx - vec_before(vx, f.vx) + gain(f.vy, y + VEC_LANES) + gain(f.vz, z + VEC_LANES);
        const vec dw = f.wx - vec_before(wx, f.wx) + gain(f.wy, y + 2 * VEC_LANES) + gain(f.wz, z + 2 * VEC_LANES);
        ux = f.ux;
        vx = f.vx;
        wx = f.wx;
        finish(sum[0], kind, du, u0, vec_shuffle_after(p0, p1) - p0, pu + i, ru + i);
        finish(sum[1], kind, dv, v0, vec_load(p + i + row) - p0, pv + i, rv + i);
        finish(sum[2], kind, dw, w0, vec_load(p + i + plane) - p0, pw + i, rw + i);
        u0 = u1;
        v0 = v1;
        w0 = w1;
        p0 = p1;
    }
}

/* A function that is compiled once for each kind. In debug builds once for all: sanitizers make it slow to compile. */
#ifdef FRANA_DEBUG
#    define FOR_EACH_KIND static
#else
#    define FOR_EACH_KIND static inline __attribute__((always_inline))
#endif

/* Rows first .. last-1 of the planes low .. high-1. */
FOR_EACH_KIND void predict_block(const struct pass *s, const struct kind kind, const int low, const int high, int first,
                                 int last) {
    const struct fluid_grid *g = s->stage->grid;
    const int *faces = s->stage->faces, end = g->m[0] - 1;
    const ptrdiff_t waiting = WAITING * s->cells;
    for (int j = first; j < last && !s->goes_on; j++)
        wait_z(s, (ptrdiff_t)fluid_grid_at(g, 0, j, low), s->z + (j - first) * waiting);
    for (int k = low; k < high; k++) {
        double *y = s->y + k * waiting;
        if (first == 0) wait_y(s, (ptrdiff_t)fluid_grid_at(g, 0, 0, k), y);
        for (int j = first; j < last; j++) {
            const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, 0, j, k);
            double *predicted[3], *rate[3];
            for (int c = 0; c < 3; c++) {
                const int advanced = c == 0 || (c == 1 ? j : k) < faces[c];
                predicted[c] = advanced ? s->predicted[c] + (n - s->shift) : s->nowhere[0];
                rate[c] = advanced ? s->rate[c] + n : s->nowhere[1];
            }
            const double side = rate[0][end];
            predict_row(s, kind, n, y, s->z + (j - first) * waiting, predicted, rate);
            if (faces[0] <= end) rate[0][end] = side;
        }
    }
}

static inline __attribute__((always_inline)) void predict_stage(const struct pass *s, int stream, int in_place, int low,
                                                                int high, int first, int last) {
    if (s->stage->b == 0)
        predict_block(s, (struct kind){0, 1, stream, in_place}, low, high, first, last);
    else if (s->stage->store_rate)
        predict_block(s, (struct kind){1, 1, stream, in_place}, low, high, first, last);
    else
        predict_block(s, (struct kind){1, 0, stream, in_place}, low, high, first, last);
}

/* The planes low .. high-1. */
static void predict_planes(const struct pass *s, int low, int high) {
    const struct fluid_grid *g = s->stage->grid;
    const int stream = g->size > STREAM, in_place = s->predicted[0] == s->q[0];
    for (int j = 0; j < g->m[1] && low < high; j += s->rows) {
        const int last = j + s->rows < g->m[1] ? j + s->rows : g->m[1];
        if (stream && in_place)
            predict_stage(s, 1, 1, low, high, j, last);
        else if (stream)
            predict_stage(s, 1, 0, low, high, j, last);
        else
            predict_stage(s, 0, 0, low, high, j, last);
    }
}

/* Copies the advanced faces of plane k from a pass that stored them apart. */
static void copy_top(const struct pass *s, int k, double *const predicted[3]) {
    const struct fluid_grid *g = s->stage->grid;
    for (int c = 0; c < 3; c++)
        for (int j = 0; j < g->m[1]; j++) {
            const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, 0, j, k);
            if (c == 0 || (c == 1 ? j : k) < s->stage->faces[c])
                memcpy(predicted[c] + n, s->predicted[c] + (n - s->shift), (size_t)s->cells * sizeof(double));
        }
}

static struct pass pass_of(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                           double *const predicted[3], double *const rate[3]) {
    const struct fluid_grid *g = s->grid;
    struct pass pass = {.stage = s, .p = p, .cells = row_cells(g), .rows = block_rows(g)};
    for (int c = 0; c < 3; c++) {
        pass.q[c] = q[c];
        pass.predicted[c] = predicted[c];
        pass.rate[c] = rate[c];
        pass.factors.convect[c] = 0.25 / g->d[c];
        pass.factors.diffuse[c] = s->viscosity / (g->d[c] * g->d[c]);
        pass.pressure[c] = s->c * s->inverse_density / g->d[c];
        pass.constant[c] = s->c * s->source[c];
    }
    pass.y = s->work;
    return pass;
}

/* A thread's share of the scratch. Returns memory for a plane stored apart; NULL with one thread. */
static double *set_scratch(struct pass *s, int part) {
    const struct fluid_grid *g = s->stage->grid;
    double *work = s->y + WAITING * g->m[2] * s->cells + (size_t)part * thread_work(g);
    s->z = work + (parts(g) > 1 ? 3 * g->plane : 0);
    s->nowhere[0] = s->z + WAITING * s->rows * s->cells;
    s->nowhere[1] = s->nowhere[0] + s->cells;
    return parts(g) > 1 ? work : NULL;
}

/* u* of plane k alone, to top[3], each [m_y] rows, of which cell (0,0) is the first. */
static struct pass predict_separately(const struct pass *s, int k, double *const top[3]) {
    struct pass separate = *s;
    separate.shift = (ptrdiff_t)fluid_grid_at(s->stage->grid, 0, 0, k);
    for (int c = 0; c < 3; c++) separate.predicted[c] = top[c];
    predict_planes(&separate, k, k + 1);
    return separate;
}

/* A thread's planes. Where u* replaces u, a thread still reads the first plane of the next one and the last plane of
 * the one before. So each computes its last plane first, into memory of its own, and puts it in its place when all are
 * done. */
static void predict_part(int thread, void *data) {
    const struct pass *all = data;
    const struct fluid_grid *g = all->stage->grid;
    const int n = parts(g), in_place = all->predicted[0] == all->q[0], separate = in_place && n > 1;
    struct pass s = *all, last = s;
    double *work = set_scratch(&s, thread < n ? thread : 0);
    const int low = (int)((long)g->m[2] * thread / n), high = (int)((long)g->m[2] * (thread + 1) / n);
    const int has = thread < n, top = high - 1;
    if (!separate) {
        if (has) predict_planes(&s, low, high);
        return;
    }
    if (has) last = predict_separately(&s, top, (double *const[]){work, work + g->plane, work + 2 * g->plane});
    threads_wait();
    if (has) predict_planes(&s, low, top);
    threads_wait();
    if (has) copy_top(&last, top, s.predicted);
}

void fluid_momentum_predict(const struct fluid_momentum_stage *s, const double *const q[3], const double *p,
                            double *const predicted[3], double *const rate[3]) {
    struct pass pass = pass_of(s, q, p, predicted, rate);
    threads_run(predict_part, &pass);
}

int fluid_momentum_group(const struct fluid_grid *g) {
    const int planes = (int)(GROUP / (row_cells(g) * g->m[1]));
    return threads_count() > 1 ? 0 : planes;
}

void fluid_momentum_predict_top(const struct fluid_momentum_stage *s, double *const q[3], const double *p,
                                double *const rate[3], double *const top[3]) {
    struct pass pass = pass_of(s, (const double *const[]){q[0], q[1], q[2]}, p, q, rate);
    set_scratch(&pass, 0);
    predict_separately(&pass, s->grid->m[2] - 1, top);
}

void fluid_momentum_predict_planes(const struct fluid_momentum_stage *s, int low, int high, double *const q[3],
                                   const double *p, double *const rate[3], double *const top[3]) {
    const int last = s->grid->m[2] - 1;
    struct pass pass = pass_of(s, (const double *const[]){q[0], q[1], q[2]}, p, q, rate);
    set_scratch(&pass, 0);
    pass.goes_on = low > 0;
    predict_planes(&pass, low, high < last ? high : last);
    if (high <= last) return;
    pass.shift = (ptrdiff_t)fluid_grid_at(s->grid, 0, 0, last);
    for (int c = 0; c < 3; c++) pass.predicted[c] = top[c];
    copy_top(&pass, last, q);
}
