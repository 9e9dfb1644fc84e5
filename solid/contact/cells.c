/* Sorts points into cells and finds those near a position, also across periodic sides. */
#include "solid/contact/cells.h"

#include "base/memory.h"
#include "base/vec.h"
#include "solid/contact/reserve.h"

#include <math.h>

/* Most cells, of n points. */
static double most(int n) { return 4.0 * n + 64; }

/* In a direction without a period the cells cover the range within DEVIATIONS standard deviations of the mean. Mean and
 * deviation are computed again from the points in this range, a few times: so a few distant points make the cells
 * neither many nor large. */
static const double DEVIATIONS = 4;
enum { TIMES = 6 };

/* The part of a direction that is divided into cells, m. In an unstable solid positions may be NaN. */
static void range(int n, const double (*x)[3], int c, double *low, double *high) {
    *low = INFINITY;
    *high = -INFINITY;
    for (int i = 0; i < n; i++) {
        if (!isfinite(x[i][c])) continue;
        *low = fmin(*low, x[i][c]);
        *high = fmax(*high, x[i][c]);
    }
    for (int k = 0; k < TIMES; k++) {
        const double middle = 0.5 * (*low + *high), from = *low, to = *high;
        double number = 0, sum = 0, square = 0;
        for (int i = 0; i < n; i++) {
            const double r = x[i][c] - middle;
            if (!(x[i][c] >= from && x[i][c] <= to)) continue;
            number++;
            sum += r;
            square += r * r;
        }
        const double mean = sum / fmax(number, 1),
                     far = DEVIATIONS * sqrt(fmax(square / fmax(number, 1) - mean * mean, 0));
        *low = fmax(from, middle + mean - far);
        *high = fmin(to, middle + mean + far);
        if (!(*low > from) && !(*high < to)) return;
    }
}

/* Chooses cells of at least reach; larger ones where there would be too many. */
static void divide(struct solid_cells *cells, const double (*x)[3], const double length[3]) {
    double extent[3], size = cells->reach, number;
    for (int c = 0; c < 3; c++) {
        double high = 0;
        cells->low[c] = 0;
        if (!(cells->period[c] > 0) && cells->n > 0) range(cells->n, x, c, &cells->low[c], &high);
        extent[c] = cells->period[c] > 0 ? length[c] : fmax(high - cells->low[c], 0);
    }
    for (;; size *= 1.25) {
        number = 1;
        for (int c = 0; c < 3; c++) number *= fmax(1, floor(extent[c] / size));
        if (number <= most(cells->n)) break;
    }
    for (int c = 0; c < 3; c++) {
        cells->count[c] = (int)fmax(1, floor(extent[c] / size));
        cells->size[c] = cells->period[c] > 0 ? length[c] / cells->count[c] : size;
    }
}

/* The cell along a direction; without a period the nearest one. */
static int along(const struct solid_cells *cells, int c, double x) {
    const int count = cells->count[c];
    const double at = floor((x - cells->low[c]) / cells->size[c]);
    if (cells->period[c] > 0) return (int)fmin(fmax(at - count * floor(at / count), 0), count - 1);
    return (int)fmin(fmax(at, 0), count - 1);
}

static int cell_of(const struct solid_cells *cells, const double x[3]) {
    return along(cells, 0, x[0]) + cells->count[0] * (along(cells, 1, x[1]) + cells->count[1] * along(cells, 2, x[2]));
}

static void reserve(struct solid_cells *cells, int number) {
    const int n = cells->n;
    cells->first = solid_contact_reserve(cells->first, &cells->first_capacity, number + 1, sizeof *cells->first);
    cells->point = solid_contact_reserve(cells->point, &cells->point_capacity, n, sizeof *cells->point);
    cells->cell = solid_contact_reserve(cells->cell, &cells->cell_capacity, n, sizeof *cells->cell);
    for (int c = 0; c < 3; c++)
        cells->x[c] = solid_contact_reserve(cells->x[c], &cells->x_capacity[c], n + VEC_LANES, sizeof *cells->x[c]);
}

void solid_contact_cells_fill(struct solid_cells *cells, int n, const double (*x)[3], double reach,
                              const int periodic[3], const double length[3]) {
    cells->n = n;
    cells->reach = reach;
    for (int c = 0; c < 3; c++) cells->period[c] = periodic[c] ? length[c] : 0;
    divide(cells, x, length);
    const int number = cells->count[0] * cells->count[1] * cells->count[2];
    reserve(cells, number);
    int *next = cells->first + 1; /* of each cell: where its next point goes; in the end where the next cell begins */
    for (int k = 0; k <= number; k++) cells->first[k] = 0;
    for (int i = 0; i < n; i++) {
        cells->cell[i] = cell_of(cells, x[i]);
        if (cells->cell[i] + 1 < number) next[cells->cell[i] + 1]++;
    }
    for (int k = 1; k < number; k++) next[k] += next[k - 1];
    for (int i = 0; i < n; i++) {
        const int at = next[cells->cell[i]]++;
        cells->point[at] = i;
        for (int c = 0; c < 3; c++) cells->x[c][at] = x[i][c];
    }
}

void solid_contact_cells_free(struct solid_cells *cells) {
    MEMORY_FREE(cells->first, cells->point, cells->cell);
    for (int c = 0; c < 3; c++) memory_free(cells->x[c]);
    *cells = (struct solid_cells){0};
}

/* The cells around one: `spans` ranges from .. to, each cell once. Across a period's ends there are two ranges. */
struct around {
    int spans, from[2], to[2];
};

static struct around around(const struct solid_cells *cells, int c, double x, int rings) {
    const int count = cells->count[c], at = along(cells, c, x), from = at - rings, to = at + rings;
    if (!(cells->period[c] > 0)) return (struct around){1, {from > 0 ? from : 0}, {to < count ? to : count - 1}};
    if (2 * rings + 1 >= count) return (struct around){1, {0}, {count - 1}};
    if (from < 0) return (struct around){2, {0, from + count}, {to, count - 1}};
    if (to >= count) return (struct around){2, {0, from}, {to - count, count - 1}};
    return (struct around){1, {from}, {to}};
}

/* x to the nearest periodic image: the sum with `magic` is rounded to a whole number. */
static inline vec shortest(vec x, double period) {
    const double magic = 0x1.8p52;
    return period > 0 ? x - period * ((x * (1 / period) + magic) - magic) : x;
}

/* Those of the points from .. to - 1, by cell, that are near. */
static int select_near(const struct solid_cells *cells, int from, int to, const double x[3], double reach2,
                       int *found) {
    int n = 0;
    for (int k = from; k < to; k += VEC_LANES) {
        vec r2 = vec_set(0);
        for (int c = 0; c < 3; c++) {
            const vec r = shortest(vec_load(cells->x[c] + k) - x[c], cells->period[c]);
            r2 += r * r;
        }
        for (unsigned near = vec_first(to - k) & vec_signs(r2 - reach2); near; near &= near - 1)
            found[n++] = cells->point[k + __builtin_ctz(near)];
    }
    return n;
}

int solid_contact_cells_near(const struct solid_cells *cells, const double x[3], int rings, int *found) {
    const double reach = rings * cells->reach * (1 + 1e-9);
    const int *count = cells->count;
    struct around axis[3];
    int n = 0;
    if (cells->n == 0) return 0;
    for (int c = 0; c < 3; c++) axis[c] = around(cells, c, x[c], rings);
    for (int b = 0; b < axis[2].spans; b++)
        for (int k = axis[2].from[b]; k <= axis[2].to[b]; k++)
            for (int a = 0; a < axis[1].spans; a++)
                for (int j = axis[1].from[a]; j <= axis[1].to[a]; j++)
                    for (int i = 0; i < axis[0].spans; i++) {
                        const int *row = cells->first + count[0] * (j + (long)count[1] * k);
                        n += select_near(cells, row[axis[0].from[i]], row[axis[0].to[i] + 1], x, reach * reach,
                                         found + n);
                    }
    return n;
}
