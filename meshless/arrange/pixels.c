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
    memory_free(g->owner);
    memory_free(g);
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

static void cells_free(struct cells *k) {
    memory_free(k->start);
    memory_free(k->item);
}

static double distance2(const struct cells *k, long p, const double at[3]) {
    double sum = 0;
    for (int c = 0; c < k->g->dim; c++) sum += (k->x[c][p] - at[c]) * (k->x[c][p] - at[c]);
    return sum;
}

/* The nearest point within the distance of which `least` is the square; -1: none. */
static long nearest_within(const struct cells *k, const double at[3], double least) {
    const double reach = sqrt(least) * (1 + 1e-12);
    long best = -1;
    int from[3] = {0}, to[3] = {0};
    for (int c = 0; c < k->g->dim; c++) {
        from[c] = cell_at(k, c, at[c] - reach);
        to[c] = cell_at(k, c, at[c] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
        for (int y = from[1]; y <= to[1]; y++) {
            const long *start = k->start + ((long)z * k->n[1] + y) * k->n[0];
            for (long q = start[from[0]]; q < start[to[0] + 1]; q++) {
                const long p = k->item[q];
                const double d = distance2(k, p, at);
                if (d > least || (d == least && best >= 0 && p > best)) continue;
                least = d;
                best = p;
            }
        }
    return best;
}

static long nearest(const struct cells *k, const double at[3], long guess, double spacing) {
    long best = guess >= 0 ? nearest_within(k, at, distance2(k, guess, at) * (1 + 1e-12)) : -1;
    for (double reach = spacing; best < 0; reach *= 2) best = nearest_within(k, at, reach * reach);
    return best;
}

void meshless_pixels_assign(struct meshless_pixels *g, long n, double *const x[3], double spacing,
                            struct meshless_moments *m) {
    struct cells k;
    cells_new(&k, g, n, x, spacing);
    memset(m->count, 0, (size_t)n * (size_t)(1 + 2 * g->dim) * sizeof *m->count);
    int *owner = g->owner;
    for (long line = g->from; line < g->to; line++) {
        const long index[3] = {0, line % g->n[1], line / g->n[1]};
        long last = -1;
        for (int i = 0; i < g->n[0]; i++, owner++) {
            if (*owner < 0) continue;
            long here[3] = {i, index[1], index[2]};
            double at[3];
            for (int c = 0; c < g->dim; c++) at[c] = g->low[c] + ((double)here[c] + 0.5) * g->width[c];
            last = nearest(&k, at, last, spacing);
            *owner = (int)last;
            m->count[last]++;
            for (int c = 0; c < g->dim; c++) {
                const long off = here[c] - meshless_pixels_at(g, c, x[c][last]);
                m->first[last * g->dim + c] += off;
                m->second[last * g->dim + c] += off * off;
            }
        }
    }
    cells_free(&k);
    par_sum_long_array(m->count, (int)(n * (1 + 2 * g->dim)));
}
