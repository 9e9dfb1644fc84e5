/* Arrangements: counts and distances, Lloyd's energy, cells by brute force, the same on every number of ranks. */
#include "base/memory.h"
#include "base/par.h"
#include "meshless/arrange/centroidal.h"
#include "tests/check.h"

#include <stdlib.h>

/* The unit disc or sphere without a quarter (an eighth), so that the shape has corners. Its faces pass beside the
 * pixels' centres, some of which are at 0 but for rounding. */
static int is_inside(const void *with, const double x[3]) {
    const int dim = *(const int *)with;
    int high = 1;
    double sum = 0;
    for (int c = 0; c < dim; c++) {
        sum += x[c] * x[c];
        high &= x[c] > 1e-5;
    }
    return sum <= 1 && !high;
}

static double measure_of(int dim) { return dim == 3 ? 4 * M_PI / 3 * 7 / 8 : dim == 2 ? M_PI * 3 / 4 : 1; }

static const int dims[] = {0, 1, 2, 3};

static struct meshless_arrange_input input(int dim, enum meshless_arrangement kind) {
    return (struct meshless_arrange_input){
        .kind = kind,
        .domain = {.dim = dim, .low = {-1, -1, -1}, .high = {1, 1, 1}, .is_inside = is_inside, .with = &dims[dim]},
        .spacing = dim == 3   ? 0.3
                   : dim == 2 ? 0.12
                              : 0.05,
        .perturbation = 0.3,
        .seed = 7};
}

static double distance2(const struct meshless_points *p, long i, const double x[3]) {
    double sum = 0;
    for (int c = 0; c < p->dim; c++) sum += (p->x[c][i] - x[c]) * (p->x[c][i] - x[c]);
    return sum;
}

static long sure; /* pixels compared */

/* The moments of all cells against a loop over all pixels and all points, which knows nothing of ranks: whole numbers,
 * so that they are equal, unless two points are equally near but for round-off. */
static void check_moments(const struct meshless_arrange_input *in, const struct meshless_points *p) {
    struct meshless_pixels *g = meshless_pixels_new(&in->domain, p->spacing);
    struct meshless_moments m = meshless_pixels_moments(g, p->n), brute = meshless_pixels_moments(g, p->n);
    meshless_pixels_assign(g, p->n, p->x, p->spacing, &m);
    long ties = 0;
    for (int k = 0; k < g->n[2]; k++)
        for (int j = 0; j < g->n[1]; j++)
            for (int i = 0; i < g->n[0]; i++) {
                const int at[3] = {i, j, k};
                double x[3] = {0}, least = INFINITY, next = INFINITY;
                long best = -1;
                for (int c = 0; c < p->dim; c++) x[c] = g->low[c] + (at[c] + 0.5) * g->width[c];
                if (!is_inside(in->domain.with, x)) continue;
                for (long q = 0; q < p->n; q++) {
                    const double d = distance2(p, q, x);
                    if (d < least) {
                        next = least;
                        least = d;
                        best = q;
                    } else if (d < next) {
                        next = d;
                    }
                }
                ties += next - least < 1e-13;
                sure++;
                brute.count[best]++;
                for (int c = 0; c < p->dim; c++) {
                    const long off = at[c] - meshless_pixels_at(g, c, p->x[c][best]);
                    brute.first[best * p->dim + c] += off;
                    brute.second[best * p->dim + c] += off * off;
                }
            }
    long moved = 0;
    for (long q = 0; q < p->n; q++) moved += labs(m.count[q] - brute.count[q]);
    check_at_most(moved, 2 * ties); /* on a line centroids are multiples of half a pixel, and ties are exact */
    if (p->dim > 1) check_equal(ties, 0);
    for (long q = 0; q < p->n * (1 + 2 * p->dim) && ties == 0; q++) check_equal(m.count[q], brute.count[q]);
    meshless_pixels_moments_free(&m);
    meshless_pixels_moments_free(&brute);
    meshless_pixels_free(g);
}

/* The start is a function of the seed alone, and so is each step of Lloyd's: the moments are the same on every number
 * of ranks, at the start and at the end. */
static void test_ranks(void **state) {
    (void)state;
    for (int dim = 1; dim < 4; dim++)
        for (int k = 0; k < 2; k++) {
            const struct meshless_arrange_input in = input(dim, k ? MESHLESS_CENTROIDAL : MESHLESS_RANDOM);
            struct meshless_points *p = meshless_arrange_new(&in);
            check_moments(&in, p);
            meshless_arrange_free(p);
        }
    check_above(sure, 10000);
}

static void test_lloyd(void **state) {
    (void)state;
    for (int dim = 1; dim < 4; dim++) {
        const struct meshless_arrange_input in = input(dim, MESHLESS_CENTROIDAL);
        struct meshless_points *p = meshless_arrange_new(&in);
        const double least = dim == 1   ? 1.0 / 12
                             : dim == 2 ? 0.0801875
                                        : 0.0785433; /* h^2 d times the second moment of
                                                      * the best cells: interval,
                                                      * hexagon, truncated octahedron */
        check_above(p->iterations, 5);
        for (int k = 1; k <= p->iterations; k++) check_at_most(p->energy[k], p->energy[k - 1] * (1 + 1e-14));
        for (int k = 1; k < p->iterations; k++) check_at_least(1 - p->energy[k] / p->energy[k - 1], 1e-6);
        check_below(1 - p->energy[p->iterations] / p->energy[p->iterations - 1], 1e-6);
        /* the energy of a cell of the best kind, from below, and within a fifth of it */
        const double cell = p->energy[p->iterations] / p->measure / (dim * p->spacing * p->spacing);
        check_between(cell, 0.97 * least, 1.2 * least);
        check_above(p->energy[0], 1.2 * p->energy[p->iterations]);
        double volume = 0;
        for (long i = 0; i < p->n; i++) volume += p->volume[i];
        check_relative(volume, p->measure, 1e-12);
        check_relative(p->measure, measure_of(dim), 0.02);
        check_equal(p->n, lrint(p->measure / pow(p->spacing, dim)));
        meshless_arrange_free(p);
    }
}

/* Distances between nearest neighbours, least and largest, in spacings. */
static void nearest(const struct meshless_points *p, double *least, double *most) {
    *least = INFINITY;
    *most = 0;
    for (long i = 0; i < p->n; i++) {
        double its = INFINITY, x[3] = {0};
        for (int c = 0; c < p->dim; c++) x[c] = p->x[c][i];
        for (long j = 0; j < p->n; j++)
            if (j != i) its = fmin(its, distance2(p, j, x));
        *least = fmin(*least, sqrt(its) / p->spacing);
        *most = fmax(*most, sqrt(its) / p->spacing);
    }
}

static void test_kinds(void **state) {
    (void)state;
    for (int dim = 1; dim < 4; dim++)
        for (enum meshless_arrangement kind = MESHLESS_LATTICE; kind <= MESHLESS_RANDOM; kind++) {
            if (dim == 1 && kind == MESHLESS_HEXAGONAL) continue;
            struct meshless_arrange_input in = input(dim, kind);
            double least, most;
            if (kind != MESHLESS_PERTURBED) in.volume = MESHLESS_CELL; /* moved points may have left the domain */
            struct meshless_points *p = meshless_arrange_new(&in);
            nearest(p, &least, &most);
            const double a = dim == 3 ? cbrt(M_SQRT2) : sqrt(2 / sqrt(3));
            if (kind == MESHLESS_LATTICE) check_close(least, 1, 1e-12);
            if (kind == MESHLESS_LATTICE) check_close(most, 1, 1e-12);
            if (kind == MESHLESS_HEXAGONAL) check_close(least, a, 1e-12);
            if (kind == MESHLESS_HEXAGONAL) check_close(most, a, 1e-12);
            if (kind == MESHLESS_PERTURBED) check_between(least, 0.39, 1);
            if (kind == MESHLESS_CENTROIDAL) check_above(least, dim == 3 ? 0.5 : 0.6);
            if (kind == MESHLESS_RANDOM) check_below(least, 0.3);
            check_relative((double)p->n, measure_of(dim) / pow(p->spacing, dim), 0.15);
            double sum = 0;
            for (long i = 0; i < p->n; i++) sum += p->volume[i];
            check_relative(sum, p->measure, 1e-12);
            meshless_arrange_free(p);
        }
}

/* Another seed gives other points, the same seed the same. */
static void test_seeds(void **state) {
    (void)state;
    for (enum meshless_arrangement kind = MESHLESS_PERTURBED; kind <= MESHLESS_RANDOM; kind++) {
        struct meshless_arrange_input in = input(2, kind);
        struct meshless_points *a = meshless_arrange_new(&in), *b = meshless_arrange_new(&in);
        in.seed = 8;
        struct meshless_points *c = meshless_arrange_new(&in);
        assert_memory_equal(a->x[0], b->x[0], (size_t)a->n * sizeof(double));
        assert_memory_equal(a->x[1], b->x[1], (size_t)a->n * sizeof(double));
        assert_memory_not_equal(a->x[0], c->x[0], (size_t)a->n * sizeof(double));
        meshless_arrange_free(a);
        meshless_arrange_free(b);
        meshless_arrange_free(c);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_kinds), cmocka_unit_test(test_lloyd),
                                       cmocka_unit_test(test_ranks), cmocka_unit_test(test_seeds)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
