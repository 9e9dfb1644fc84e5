/* Pixels of a domain, and the nearest point to each by a cell list. */
#include "meshless/arrange/pixels.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Pixels a spacing in one, two and three dimensions. */
static const int fine[] = {0, 256, 16, 6};

struct meshless_pixels *meshless_pixels_new(const struct meshless_domain *domain, double spacing) {
    struct meshless_pixels *g = memory_new(MEMORY_SOLID, 1, sizeof *g);
    double all = 1;
    g->dim = domain->dim;
    g->measure = 1;
    for (int c = 0; c < 3; c++) g->n[c] = 1;
    for (int c = 0; c < g->dim; c++) {
        const double extent = domain->high[c] - domain->low[c], wanted = ceil(extent / spacing * fine[g->dim] - 1e-9);
        all *= wanted;
        if (!(all < INT_MAX))
            die_all(
                EXIT_CODE_SCENE,
                "an arrangement of points %g m apart in a domain of %g m needs %.3g pixels or more, the limit is %d: "
                "a larger spacing needs fewer",
                spacing, extent, all, INT_MAX);
        g->n[c] = wanted < 1 ? 1 : (int)wanted;
        g->low[c] = domain->low[c];
        g->width[c] = extent / g->n[c];
        g->measure *= g->width[c];
    }
    const long lines = (long)g->n[1] * g->n[2], size = par_size(), rank = par_rank();
    g->from = lines * rank / size;
    g->to = lines * (rank + 1) / size;
    g->owner = memory_new(MEMORY_SOLID, (size_t)(g->to - g->from) * (size_t)g->n[0] + 1, sizeof *g->owner);
    int *owner = g->owner;
    for (long line = g->from; line < g->to; line++)
        for (int i = 0; i < g->n[0]; i++, owner++) {
            const double x[3] = {g->low[0] + (i + 0.5) * g->width[0],
                                 g->low[1] + ((double)(line % g->n[1]) + 0.5) * g->width[1],
                                 g->low[2] + ((double)(line / g->n[1]) + 0.5) * g->width[2]};
            *owner = domain->is_inside(domain->with, x) ? 0 : -1;
            g->inside += *owner == 0;
        }
    g->inside = par_sum_long(g->inside);
    return g;
}

void meshless_pixels_free(struct meshless_pixels *g) {
    if (!g) return;
    MEMORY_FREE(g->owner, g);
}

long meshless_pixels_at(const struct meshless_pixels *g, int c, double x) {
    return (long)floor((x - g->low[c]) / g->width[c]);
}

struct meshless_moments meshless_pixels_moments(const struct meshless_pixels *g, long n) {
    struct meshless_moments m;
    m.count = memory_new(MEMORY_SOLID, (size_t)n * (size_t)(1 + 2 * g->dim) + 1, sizeof *m.count);
    m.first = m.count + n;
    m.second = m.first + n * g->dim;
    return m;
}

void meshless_pixels_moments_free(struct meshless_moments *m) { memory_free(m->count); }

/* The points sorted into cells about a spacing wide. */
struct cells {
    const struct meshless_pixels *g;
    double *const *x;
    double width[3];
    int n[3];
    long *start, *item; /* [cells + 2], [points] */
};

static int cell_at(const struct cells *k, int c, double x) {
    const double at = floor((x - k->g->low[c]) / k->width[c]);
    return at < 0 ? 0 : at >= k->n[c] ? k->n[c] - 1 : (int)at; /* points outside belong to the cells at the edge */
}

static long cell_of(const struct cells *k, long p) {
    long cell = 0;
    for (int c = k->g->dim - 1; c >= 0; c--) cell = cell * k->n[c] + cell_at(k, c, k->x[c][p]);
    return cell;
}

static void cells_new(struct cells *k, const struct meshless_pixels *g, long n, double *const x[3], double spacing) {
    *k = (struct cells){.g = g, .x = x, .n = {1, 1, 1}};
    long all = 1;
    for (int c = 0; c < g->dim; c++) {
        const double extent = g->n[c] * g->width[c];
        k->n[c] = (int)fmax(1, floor(extent / spacing));
        k->width[c] = extent / k->n[c];
        all *= k->n[c];
    }
    k->start = memory_new(MEMORY_SOLID, (size_t)all + 2, sizeof *k->start);
    k->item = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *k->item);
    for (long p = 0; p < n; p++) k->start[cell_of(k, p) + 2]++;
    for (long q = 2; q < all + 2; q++) k->start[q] += k->start[q - 1];
    for (long p = 0; p < n; p++) k->item[k->start[cell_of(k, p) + 1]++] = p;
}

static void cells_free(struct cells *k) { MEMORY_FREE(k->start, k->item); }

static double distance2(const struct cells *k, long p, const double at[3]) {
    double sum = 0;
    for (int c = 0; c < k->g->dim; c++) sum += (k->x[c][p] - at[c]) * (k->x[c][p] - at[c]);
    return sum;
}

enum { NEAR = 512 };

/* The points no farther than `reach` from a place: at most NEAR numbers. Returns how many there are. */
static int near_of(const struct cells *k, const double at[3], double reach, long near[NEAR]) {
    const double wide = reach * (1 + 1e-9);
    int from[3] = {0}, to[3] = {0}, n = 0;
    for (int c = 0; c < k->g->dim; c++) {
        from[c] = cell_at(k, c, at[c] - wide);
        to[c] = cell_at(k, c, at[c] + wide);
    }
    for (int z = from[2]; z <= to[2]; z++)
        for (int y = from[1]; y <= to[1]; y++) {
            const long *start = k->start + ((long)z * k->n[1] + y) * k->n[0];
            for (long q = start[from[0]]; q < start[to[0] + 1]; q++) {
                if (distance2(k, k->item[q], at) > wide * wide) continue;
                if (n < NEAR) near[n] = k->item[q];
                n++;
            }
        }
    return n;
}

/* The nearest of some points; of several equally near the lowest number. */
static long best_of(const struct cells *k, const double at[3], int n, const long *near) {
    double least = INFINITY;
    long best = -1;
    for (int q = 0; q < n; q++) {
        const double d = distance2(k, near[q], at);
        if (d > least || (d == least && near[q] > best)) continue;
        least = d;
        best = near[q];
    }
    return best;
}

/* A block of pixels that share their candidates: from[c] <= index < to[c]. */
struct block {
    int from[3], to[3];
};

static void place_of(const struct meshless_pixels *g, const double index[3], double at[3]) {
    for (int c = 0; c < g->dim; c++) at[c] = g->low[c] + (index[c] + 0.5) * g->width[c];
}

/* All points that can be the nearest one to some pixel of a block: those no farther from its middle than the nearest
 * one, and twice the distance from the middle to its farthest pixel. More than NEAR of them: 0. */
static int candidates(const struct cells *k, const struct block *b, double spacing, double middle[3], long near[NEAR]) {
    const struct meshless_pixels *g = k->g;
    const double index[3] = {0.5 * (b->from[0] + b->to[0] - 1), 0.5 * (b->from[1] + b->to[1] - 1),
                             0.5 * (b->from[2] + b->to[2] - 1)};
    double half = 0;
    int n = 0;
    place_of(g, index, middle);
    for (int c = 0; c < g->dim; c++) half += pow(0.5 * (b->to[c] - b->from[c] - 1) * g->width[c], 2);
    for (double reach = spacing; n == 0; reach *= 1.5) n = near_of(k, middle, reach, near);
    if (n > NEAR) return 0;
    const double nearest = sqrt(distance2(k, best_of(k, middle, n, near), middle));
    n = near_of(k, middle, nearest + 2 * sqrt(half), near);
    return n > NEAR ? 0 : n;
}

/* The points of a block of pixels: their places, in three directions, and their own pixels. */
struct choice {
    int n;
    long number[NEAR], own_pixel[NEAR][3];
    double x[3][NEAR];
};

static void choice_fill(struct choice *few, const struct cells *k, const struct block *b, double spacing) {
    double middle[3] = {0};
    few->n = candidates(k, b, spacing, middle, few->number);
    if (few->n == 0)
        die(EXIT_CODE_SCENE,
            "more than %d points of the arrangement lie within some spacings of %g m about (%g, %g, %g): another seed "
            "spreads them",
            NEAR, spacing, middle[0], middle[1], middle[2]);
    for (int q = 0; q < few->n; q++)
        for (int c = 0; c < k->g->dim; c++) {
            few->x[c][q] = k->x[c][few->number[q]];
            few->own_pixel[q][c] = meshless_pixels_at(k->g, c, few->x[c][q]);
        }
}

/* The nearest one; of several equally near the lowest number. */
static int choice_best(const struct choice *few, const double at[3]) {
    double d[NEAR];
    int best = 0;
    for (int q = 0; q < few->n; q++) {
        const double a = few->x[0][q] - at[0], b = few->x[1][q] - at[1], c = few->x[2][q] - at[2];
        d[q] = a * a + b * b + c * c;
    }
    for (int q = 1; q < few->n; q++)
        if (d[q] < d[best] || (d[q] == d[best] && few->number[q] < few->number[best])) best = q;
    return best;
}

/* Gives the block's pixels on this rank to their nearest points. */
static void assign_block(struct meshless_pixels *g, const struct cells *k, const struct block *b, double spacing,
                         struct choice *few, struct meshless_moments *m) {
    few->n = 0;
    for (int z = b->from[2]; z < b->to[2]; z++)
        for (int y = b->from[1]; y < b->to[1]; y++) {
            const long line = (long)z * g->n[1] + y;
            if (line < g->from || line >= g->to) continue;
            int *owner = g->owner + (line - g->from) * g->n[0];
            for (int x = b->from[0]; x < b->to[0]; x++) {
                if (owner[x] < 0) continue;
                if (few->n == 0) choice_fill(few, k, b, spacing);
                const int pixel[3] = {x, y, z};
                double at[3] = {0};
                place_of(g, (const double[3]){x, y, z}, at);
                const int best = choice_best(few, at);
                const long p = few->number[best];
                owner[x] = (int)p;
                m->count[p]++;
                for (int c = 0; c < g->dim; c++) {
                    const long off = pixel[c] - few->own_pixel[best][c];
                    m->first[p * g->dim + c] += off;
                    m->second[p * g->dim + c] += off * off;
                }
            }
        }
}

void meshless_pixels_assign(struct meshless_pixels *g, long n, double *const x[3], double spacing,
                            struct meshless_moments *m) {
    struct cells k;
    struct choice few = {0};
    const int edge = fine[g->dim] / 2; /* of a block, in pixels */
    cells_new(&k, g, n, x, spacing);
    memset(m->count, 0, (size_t)n * (size_t)(1 + 2 * g->dim) * sizeof *m->count);
    const int first = (int)(g->from / g->n[1]), last = (int)((g->to + g->n[1] - 1) / g->n[1]); /* planes of this rank */
    for (int z = first; z < last; z += edge)
        for (int y = 0; y < g->n[1]; y += edge)
            for (int from = 0; from < g->n[0]; from += edge) {
                struct block b = {.from = {from, y, z}};
                for (int c = 0; c < 3; c++) {
                    const int end = c == 2 ? last : g->n[c];
                    b.to[c] = b.from[c] + edge < end ? b.from[c] + edge : end;
                }
                assign_block(g, &k, &b, spacing, &few, m);
            }
    cells_free(&k);
    par_sum_long_array(m->count, (int)(n * (1 + 2 * g->dim)));
}
