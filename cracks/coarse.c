/* Bricks of wet particles: the slow part of the preconditioner. */
#include "cracks/coarse.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/solve.h"
#include "physics/chebyshev.h"

#include <math.h>
#include <string.h>

enum {
    SIDE_MIN = 4,       /* spacings */
    SIDE_MAX = 10,      /* larger ones are of no use: the polynomial on the particles would be long */
    LONG = 6,           /* bricks along an axis, at least: a shorter crack needs none */
    BRICKS_MAX = 32768, /* of a rank, which holds all */
    SHARE = 4           /* wet particles for each brick of the box, at least */
};

/* The number of terms over sqrt(span). */
static const double TERMS = 1.5;

struct cracks_border {
    long link;      /* 8 entry + lane: of the conductance */
    int own, other; /* places of the ends */
    int at;         /* in the matrix */
};

/* The site of a particle on the lattice, along an axis. */
static long site_of(const struct solid *s, int h, int axis) {
    return axis < s->dim ? lrint(floor(s->x0[axis][h] / s->in.spacing + 0.25)) : 0;
}

/* The least and largest site of all wet particles, and how many they are. */
static double box_of(const struct cracks *c, long low[3], long high[3]) {
    const struct cracks_struts *t = &c->struts;
    double end[6] = {-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < t->n; i++) {
        for (int k = 0; k < 3; k++) {
            const double site = (double)site_of(c->solid, t->h[i], k);
            end[k] = fmax(end[k], -site);
            end[3 + k] = fmax(end[3 + k], site);
        }
    }
    par_max_array(end, 6);
    for (int k = 0; k < 3; k++) {
        low[k] = isfinite(end[k]) ? -(long)end[k] : 0;
        high[k] = isfinite(end[k]) ? (long)end[3 + k] : 0;
    }
    return par_sum((double)t->n);
}

static int bricks_along(const long low, const long high, int side) { return (int)((high - low) / side) + 1; }

/* Bricks as small as SIDE_MIN, unless they would be too many. */
static void divide(struct cracks_coarse *b, const long low[3], const long high[3], double n) {
    for (b->side = SIDE_MIN;; b->side++) {
        double bricks = 1;
        b->longest = 1;
        for (int k = 0; k < 3; k++) {
            const int along = bricks_along(low[k], high[k], b->side);
            bricks *= along + 2;
            b->longest = along > b->longest ? along : b->longest;
        }
        if (bricks <= fmin(fmax(n / SHARE, 512), BRICKS_MAX)) break;
    }
    b->stride[0] = 1;
    for (int k = 0; k < 2; k++) b->stride[k + 1] = b->stride[k] * (bricks_along(low[k], high[k], b->side) + 2);
    b->useful = b->side <= SIDE_MAX && b->longest >= LONG;
    b->bricks = b->stride[2] * (bricks_along(low[2], high[2], b->side) + 2);
}

static void reserve(struct cracks_coarse *b, int n) {
    const size_t bricks = (size_t)b->bricks;
    b->brick = memory_renew(MEMORY_SOLID, b->brick, (size_t)n + 1, sizeof *b->brick);
    if (b->bricks <= b->capacity) return;
    b->capacity = b->bricks;
    b->matrix = memory_renew(MEMORY_SOLID, b->matrix, 4 * bricks, sizeof *b->matrix);
    double **const array[] = {&b->inverse, &b->residual, &b->x, &b->next, &b->change};
    for (size_t a = 0; a < sizeof array / sizeof array[0]; a++)
        *array[a] = memory_renew(MEMORY_SOLID, *array[a], bricks, sizeof **array[a]);
}

/* The links from a brick to the next one along each axis. */
static void find_borders(struct cracks_coarse *b, const struct cracks *c, const long low[3], const long high[3]) {
    const struct cracks_rows *r = &c->struts.rows;
    b->borders = 0;
    for (int row = 0; row < r->n; row++)
        for (long k = r->link_start[row]; k < r->link_start[row + 1]; k++) {
            const struct cracks_entry e = r->link[k];
            const int axis = e.kind / 2;
            if (e.kind % 2 == 0) continue;
            if (b->borders + CRACKS_LANES > b->borders_capacity) {
                const int capacity = 2 * b->borders_capacity + 64 * CRACKS_LANES;
                b->border =
                    memory_grown(MEMORY_SOLID, b->border, (size_t)b->borders, (size_t)capacity, sizeof *b->border);
                b->borders_capacity = capacity;
            }
            for (int lane = 0; lane < CRACKS_LANES; lane++) {
                const int i = e.lanes >> lane & 1 ? r->index[row][lane] : -1;
                if (i < 0) continue;
                const long site = site_of(c->solid, c->struts.h[i], axis);
                if ((site - low[axis] + 1) % b->side || site >= high[axis]) continue;
                b->border[b->borders++] = (struct cracks_border){CRACKS_LANES * k + lane, r->first[row] + lane,
                                                                 e.at + lane, (1 + axis) * b->bricks + b->brick[i]};
            }
        }
}

struct cracks_coarse *cracks_coarse_renew(struct cracks_coarse *b, const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    long low[3], high[3];
    if (!b) b = memory_new(MEMORY_SOLID, 1, sizeof *b);
    if (b->version == t->version) return b;
    b->version = t->version;
    const double n = box_of(c, low, high);
    divide(b, low, high, n);
    reserve(b, t->n);
    for (int i = 0; i < t->n; i++) {
        b->brick[i] = 0;
        for (int k = 0; k < 3; k++)
            b->brick[i] += b->stride[k] * (int)((site_of(c->solid, t->h[i], k) - low[k]) / b->side + 1);
    }
    find_borders(b, c, low, high);
    return b;
}

void cracks_coarse_free(struct cracks_coarse *b) {
    if (!b) return;
    MEMORY_FREE(b->brick, b->border, b->matrix, b->inverse, b->residual, b->x, b->next, b->change, b);
}

/* From the middle of a brick to that of the next one there are `side` links in a row. */
void cracks_coarse_begin(struct cracks_coarse *b, const struct cracks *c, double dt, const double *mass,
                         const double *full) {
    const int n = b->bricks;
    const double *conductance = c->work->conductance;
    const double factor = dt / b->side;
    memset(b->matrix, 0, 4 * (size_t)n * sizeof *b->matrix);
    for (int i = 0; i < c->struts.n; i++)
        if (full[c->struts.place[i]] > 0) b->matrix[b->brick[i]] += mass[i];
    for (int k = 0; k < b->borders; k++) {
        const struct cracks_border *e = &b->border[k];
        b->matrix[e->at] += factor * conductance[e->link] * (full[e->own] * full[e->other]);
    }
    par_sum_array(b->matrix, 4 * n);
    double sum[2] = {0, 0};
    memset(b->inverse, 0, (size_t)n * sizeof *b->inverse);
    for (int q = b->stride[2]; q < n - b->stride[2]; q++) {
        double all = b->matrix[q];
        if (!(all > 0)) continue;
        sum[0] += all;
        for (int k = 0; k < 3; k++) all += b->matrix[(1 + k) * n + q] + b->matrix[(1 + k) * n + q - b->stride[k]];
        sum[1] += all;
        b->inverse[q] = 1 / all;
    }
    b->span = sum[0] > 0 ? fmin(2 * sum[1] / sum[0], fmax(2 * (double)b->longest * b->longest, 2)) : 2;
    b->terms = (int)ceil(TERMS * sqrt(b->span));
}

/* A term of Chebyshev's iteration: change = keep change + gain (D^-1 (residual + flow) - x), next = x + change. */
static void relax(const struct cracks_coarse *b, double keep, double gain, const double *restrict x,
                  double *restrict next) {
    const int n = b->bricks, sx = b->stride[0], sy = b->stride[1], sz = b->stride[2];
    const double *restrict tx = b->matrix + n, *restrict ty = tx + n, *restrict tz = ty + n;
    const double *restrict inverse = b->inverse, *restrict residual = b->residual;
    double *restrict change = b->change;
    for (int q = sz; q < n - sz; q++) {
        const double flow = tx[q] * x[q + sx] + tx[q - sx] * x[q - sx] + ty[q] * x[q + sy] + ty[q - sy] * x[q - sy] +
                            tz[q] * x[q + sz] + tz[q - sz] * x[q - sz];
        change[q] = keep * change[q] + gain * (inverse[q] * (residual[q] + flow) - x[q]);
        next[q] = x[q] + change[q];
    }
}

void cracks_coarse_solve(struct cracks_coarse *b) {
    struct physics_chebyshev term = physics_chebyshev_of(2 / b->span, 2);
    const size_t bytes = (size_t)b->bricks * sizeof *b->x;
    par_sum_array(b->residual, b->bricks);
    memset(b->x, 0, bytes);
    memset(b->next, 0, bytes);
    memset(b->change, 0, bytes);
    physics_chebyshev_next(&term);
    for (int q = 0; q < b->bricks; q++) b->x[q] = b->change[q] = b->inverse[q] * b->residual[q] / term.middle;
    for (int k = 1; k < b->terms; k++) {
        physics_chebyshev_next(&term);
        relax(b, term.keep, term.gain, b->x, b->next);
        double *const before = b->x;
        b->x = b->next;
        b->next = before;
    }
}
