#include "solid/points.h"
#include "base/memory.h"
#include "solid/weight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 24 }; /* of the partial volume's quadrature: 1e-4 */

struct solid_points {
    long n;
    double *x[3], *volume, *horizon; /* [n] by number */
    double spacing, low[3], cell;    /* cells as wide as the longest bond */
    int cells[3];
    long *cell_start, *cell_point; /* points sorted by cell */
    double period[3];              /* 0: not periodic */
    const char *name;
};

static int clamp_cell(const struct solid_points *p, int c, double x) {
    const int i = (int)floor((x - p->low[c]) / p->cell);
    return i < 0 ? 0 : i >= p->cells[c] ? p->cells[c] - 1 : i;
}

static long cell_of(const struct solid_points *p, long i) {
    return ((long)clamp_cell(p, 2, p->x[2][i]) * p->cells[1] + clamp_cell(p, 1, p->x[1][i])) * p->cells[0] +
           clamp_cell(p, 0, p->x[0][i]);
}

static void sort_into_cells(struct solid_points *p, double longest) {
    double high[3];
    p->cell = longest;
    long cells = 1;
    for (int c = 0; c < 3; c++) {
        p->low[c] = INFINITY;
        high[c] = -INFINITY;
        for (long i = 0; i < p->n; i++) {
            p->low[c] = fmin(p->low[c], p->x[c][i]);
            high[c] = fmax(high[c], p->x[c][i]);
        }
        p->cells[c] = (int)((high[c] - p->low[c]) / p->cell) + 1;
        cells *= p->cells[c];
    }
    p->cell_start = memory_new(MEMORY_SOLID, (size_t)cells + 2, sizeof *p->cell_start);
    p->cell_point = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *p->cell_point);
    for (long i = 0; i < p->n; i++) p->cell_start[cell_of(p, i) + 2]++;
    for (long q = 2; q < cells + 2; q++) p->cell_start[q] += p->cell_start[q - 1];
    for (long i = 0; i < p->n; i++) p->cell_point[p->cell_start[cell_of(p, i) + 1]++] = i;
}

struct solid_points *solid_points_new(const struct solid_input *in, const struct solid_body *body,
                                      const struct solid_sites *t, double horizon) {
    struct solid_points *p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    p->n = t->count;
    p->spacing = in->spacing;
    p->name = body->name;
    p->volume = memory_new(MEMORY_SOLID, (size_t)p->n, sizeof *p->volume);
    p->horizon = memory_new(MEMORY_SOLID, (size_t)p->n, sizeof *p->horizon);
    for (int c = 0; c < 3; c++) {
        p->x[c] = memory_new(MEMORY_SOLID, (size_t)p->n, sizeof *p->x[c]);
        p->period[c] = in->periodic[c] ? in->length[c] : 0;
    }
    for (long i = 0; i < p->n; i++) {
        for (int c = 0; c < 3; c++) p->x[c][i] = body->point[c][t->point[i]];
        p->volume[i] = body->point_volume[t->point[i]];
        p->horizon[i] = horizon;
        if (!(p->volume[i] > 0))
            die_all(EXIT_CODE_SCENE, "point %ld of solid body %s has no volume (%g)", t->point[i], p->name,
                    p->volume[i]);
    }
    sort_into_cells(p, horizon + in->spacing);
    return p;
}

void solid_points_free(struct solid_points *p) {
    if (!p) return;
    for (int c = 0; c < 3; c++) memory_free(p->x[c]);
    memory_free(p->volume);
    memory_free(p->horizon);
    memory_free(p->cell_start);
    memory_free(p->cell_point);
    memory_free(p);
}

static void consider(const struct solid_points *p, long h, long l, const int image[3],
                     struct solid_points_near *near) {
    if (l == h) return;
    double xi[3], length2 = 0;
    for (int c = 0; c < 3; c++) {
        xi[c] = (p->x[c][l] - p->x[c][h]) + image[c] * p->period[c];
        length2 += xi[c] * xi[c];
    }
    const double horizon = 0.5 * (p->horizon[h] + p->horizon[l]), limit = horizon + 0.5 * p->spacing;
    if (length2 >= limit * limit * (1 - 1e-12)) return;
    if (length2 == 0) die(EXIT_CODE_SCENE, "two points of solid body %s coincide", p->name);
    if (near->n == SOLID_FAMILY_MAX)
        die(EXIT_CODE_SCENE, "a point of solid body %s has more than %d neighbours", p->name,
            SOLID_FAMILY_MAX);
    const double fraction = 0.5 * (solid_weight_fraction(xi, cbrt(p->volume[l]), horizon, COLUMNS) +
                                   solid_weight_fraction(xi, cbrt(p->volume[h]), horizon, COLUMNS));
    int k = near->n++;
    for (; k > 0; k--) { /* ascending, images of one point by xi */
        const long before = near->number[k - 1];
        if (before < l || (before == l && memcmp(near->xi[k - 1], xi, sizeof xi) < 0)) break;
        near->number[k] = before;
        near->weight[k] = near->weight[k - 1];
        memcpy(near->xi[k], near->xi[k - 1], sizeof xi);
        memcpy(near->image[k], near->image[k - 1], sizeof near->image[k]);
    }
    near->number[k] = l;
    near->weight[k] = fraction * p->volume[l];
    memcpy(near->xi[k], xi, sizeof xi);
    memcpy(near->image[k], image, sizeof near->image[k]);
}

void solid_points_near(const struct solid_points *p, long h, struct solid_points_near *near) {
    near->n = 0;
    int image[3], most[3];
    for (int c = 0; c < 3; c++) most[c] = p->period[c] > 0;
    for (image[2] = -most[2]; image[2] <= most[2]; image[2]++)
        for (image[1] = -most[1]; image[1] <= most[1]; image[1]++)
            for (image[0] = -most[0]; image[0] <= most[0]; image[0]++) {
                int from[3], to[3];
                for (int c = 0; c < 3; c++) {
                    const double x = p->x[c][h] - image[c] * p->period[c];
                    from[c] = clamp_cell(p, c, x - p->cell);
                    to[c] = clamp_cell(p, c, x + p->cell);
                }
                for (int k = from[2]; k <= to[2]; k++)
                    for (int j = from[1]; j <= to[1]; j++)
                        for (int i = from[0]; i <= to[0]; i++) {
                            const long cell = ((long)k * p->cells[1] + j) * p->cells[0] + i;
                            const long *start = &p->cell_start[cell];
                            for (long q = start[0]; q < start[1]; q++)
                                consider(p, h, p->cell_point[q], image, near);
                        }
            }
}
