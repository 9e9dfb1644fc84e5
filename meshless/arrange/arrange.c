/* Puts points into a domain: on a lattice, on a hexagonal one, moved at random, at random, or centroidal. */
#include "meshless/arrange/arrange.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/hash.h"
#include "base/memory.h"
#include "meshless/arrange/centroidal.h"

#include <math.h>

static void points_reserve(struct meshless_points *p, long capacity) {
    for (int c = 0; c < p->dim; c++)
        p->x[c] = memory_grown(MEMORY_SOLID, p->x[c], (size_t)p->n, (size_t)capacity + 1, sizeof(double));
}

/* Adds a point, if it is inside; its move is added after that. */
static void add(struct meshless_points *p, const struct meshless_arrange_input *in, const double x[3],
                const double move[3], long *capacity) {
    if (!in->domain.is_inside(in->domain.with, x)) return;
    if (p->n == *capacity) points_reserve(p, *capacity = 2 * *capacity + 64);
    for (int c = 0; c < p->dim; c++) p->x[c][p->n] = x[c] + move[c];
    p->n++;
}

/* The whole numbers i for which origin + (i + shift) step may lie between the bounds. */
static void range(const struct meshless_arrange_input *in, int c, double step, int from[3], int to[3]) {
    from[c] = (int)floor((in->domain.low[c] - in->origin[c]) / step) - 2;
    to[c] = (int)ceil((in->domain.high[c] - in->origin[c]) / step) + 2;
}

/* Points at origin + (i + 1/2) h, each moved by up to `perturbation`. */
static void put_lattice(struct meshless_points *p, const struct meshless_arrange_input *in) {
    const double h = p->spacing, most = in->kind == MESHLESS_PERTURBED ? in->perturbation * h : 0;
    int from[3] = {0}, to[3] = {0};
    long capacity = 0;
    for (int c = 0; c < p->dim; c++) range(in, c, h, from, to);
    for (int k = from[2]; k <= to[2]; k++)
        for (int j = from[1]; j <= to[1]; j++)
            for (int i = from[0]; i <= to[0]; i++) {
                const int site[3] = {i, j, k};
                double x[3] = {0}, move[3] = {0};
                for (int c = 0; c < p->dim; c++) {
                    x[c] = in->origin[c] + (site[c] + 0.5) * h;
                    if (most > 0) move[c] = most * hash_even(in->seed, i, j + k * (1L << 32), c);
                }
                add(p, in, x, move, &capacity);
            }
}

/* Triangles of side a in the plane, h^2 = a^2 sqrt(3)/2, in rows along x; in space close-packed layers of them, ABAB,
 * h^3 = a^3 / sqrt(2). */
static void put_hexagonal(struct meshless_points *p, const struct meshless_arrange_input *in) {
    const double a = p->dim == 3 ? p->spacing * cbrt(M_SQRT2) : p->spacing * sqrt(2 / sqrt(3)),
                 step[3] = {a, a * sqrt(0.75), a * sqrt(2.0 / 3)}, none[3] = {0};
    int from[3] = {0}, to[3] = {0};
    long capacity = 0;
    ENSURE(p->dim > 1, "a hexagonal arrangement in one dimension");
    for (int c = 0; c < p->dim; c++) range(in, c, step[c], from, to);
    for (int k = from[2]; k <= to[2]; k++)
        for (int j = from[1]; j <= to[1]; j++)
            for (int i = from[0]; i <= to[0]; i++) {
                const double odd = j & 1, layer = p->dim == 3 ? k & 1 : 0;
                const double x[3] = {in->origin[0] + (i + 0.25 + 0.5 * odd + 0.5 * layer) * step[0],
                                     in->origin[1] + (j + 0.5 + layer / 3) * step[1],
                                     in->origin[2] + (k + 0.5) * step[2]};
                add(p, in, x, none, &capacity);
            }
}

/* Even in the domain: in its bounds, and inside. */
static void put_random(struct meshless_points *p, const struct meshless_arrange_input *in, long n) {
    const double none[3] = {0};
    long capacity = 0, tries = 0;
    for (; p->n < n; tries++) {
        double x[3] = {0};
        ENSURE(tries < 1000 * (n + 1000), "%ld tries for %ld points", tries, n);
        for (int c = 0; c < p->dim; c++) {
            const double half = 0.5 * (in->domain.high[c] - in->domain.low[c]);
            x[c] = in->domain.low[c] + half * (1 + hash_even(in->seed, tries, -1, c));
        }
        add(p, in, x, none, &capacity);
    }
}

static double power(double x, int n) { return n == 3 ? x * x * x : n == 2 ? x * x : x; }

/* The Voronoi cells, scaled so that together they are the domain. */
static void measure_cells(struct meshless_points *p, struct meshless_pixels *g) {
    struct meshless_moments m = meshless_pixels_moments(g, p->n);
    meshless_pixels_assign(g, p->n, p->x, p->spacing, &m);
    for (long i = 0; i < p->n; i++) {
        if (m.count[i] == 0)
            die_all(
                EXIT_CODE_SCENE,
                "point %ld of the arrangement, at (%g, %g, %g), has no Voronoi cell: another point is too near, or it "
                "lies outside; volume: equal needs no cells",
                i, p->x[0][i], p->dim > 1 ? p->x[1][i] : 0, p->dim > 2 ? p->x[2][i] : 0);
        p->volume[i] = p->measure * ((double)m.count[i] / (double)g->inside);
    }
    meshless_pixels_moments_free(&m);
}

static void put(struct meshless_points *p, const struct meshless_arrange_input *in, struct meshless_pixels *g) {
    const long n = in->points > 0 ? in->points : lrint(p->measure / power(p->spacing, p->dim));
    switch (in->kind) {
    case MESHLESS_LATTICE:
    case MESHLESS_PERTURBED:
        put_lattice(p, in);
        return;
    case MESHLESS_HEXAGONAL:
        put_hexagonal(p, in);
        return;
    case MESHLESS_RANDOM:
        put_random(p, in, n);
        return;
    case MESHLESS_CENTROIDAL:
        put_random(p, in, n);
        if (p->n > 0) meshless_centroidal(p, g);
        return;
    }
    ENSURE(0, "arrangement %d", (int)in->kind);
}

struct meshless_points *meshless_arrange_new(const struct meshless_arrange_input *in) {
    struct meshless_points *p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    const struct meshless_domain *d = &in->domain;
    struct meshless_pixels *g = NULL;
    const double n = (double)in->points;
    p->dim = d->dim;
    p->measure = d->measure;
    double box = 1;
    for (int c = 0; c < d->dim; c++) box *= d->high[c] - d->low[c];
    p->spacing = in->spacing > 0 ? in->spacing : pow((d->measure > 0 ? d->measure : box) / n, 1.0 / d->dim);
    if (in->kind == MESHLESS_CENTROIDAL || in->volume == MESHLESS_CELL || !(d->measure > 0)) {
        g = meshless_pixels_new(d, p->spacing);
        if (!(d->measure > 0)) p->measure = (double)g->inside * g->measure;
    }
    if (in->spacing <= 0) p->spacing = pow(p->measure / n, 1.0 / d->dim);
    if (p->measure > 0) put(p, in, g);
    if (p->n == 0)
        die_all(EXIT_CODE_SCENE, "the arrangement holds no point at spacing %g m: a smaller spacing gives some",
                p->spacing);
    p->volume = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *p->volume);
    for (long i = 0; i < p->n; i++) p->volume[i] = p->measure / (double)p->n;
    if (in->volume == MESHLESS_CELL) measure_cells(p, g);
    meshless_pixels_free(g);
    return p;
}

void meshless_arrange_free(struct meshless_points *p) {
    if (!p) return;
    for (int c = 0; c < p->dim; c++) memory_free(p->x[c]);
    MEMORY_FREE(p->volume, p->energy, p);
}
