/* Partial volumes of cubic cells in the horizon's sphere, and a lattice family's stencil.  (001: sec. 3.3.5) */
#include "solid/law/weight.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/bonds/family.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 400 }; /* columns along a side of a cube's face: fractions accurate to 1e-6 */

/* Columns are along the largest component of a, on cells x cells points of the face; the length of each column inside
 * the sphere is exact. */
static double fraction_of_sorted(const double a[3], double side, double radius, int cells) {
    double sum = 0;
    for (int j = 0; j < cells; j++) {
        const double y = a[1] + side * ((j + 0.5) / cells - 0.5);
        for (int i = 0; i < cells; i++) {
            const double x = a[0] + side * ((i + 0.5) / cells - 0.5);
            const double h2 = radius * radius - x * x - y * y;
            if (h2 <= 0) continue;
            const double h = sqrt(h2);
            const double column = fmin(a[2] + side / 2, h) - fmax(a[2] - side / 2, -h);
            if (column > 0) sum += column;
        }
    }
    return sum / (side * cells * cells);
}

static void swap_ordered(double *a, double *b) {
    if (*a > *b) {
        const double t = *a;
        *a = *b;
        *b = t;
    }
}

static void sort(const double xi[3], double a[3]) {
    for (int c = 0; c < 3; c++) a[c] = fabs(xi[c]);
    swap_ordered(&a[0], &a[1]);
    swap_ordered(&a[1], &a[2]);
    swap_ordered(&a[0], &a[1]);
}

/* 1: inside the sphere, 0: outside, -1: the sphere cuts the cube. */
static int inside(const double a[3], double side, double radius) {
    double far = 0, near = 0;
    for (int c = 0; c < 3; c++) {
        const double low = fmax(a[c] - side / 2, 0), high = a[c] + side / 2;
        near += low * low;
        far += high * high;
    }
    if (far <= radius * radius) return 1;
    return near >= radius * radius ? 0 : -1;
}

double solid_weight_fraction(const double xi[3], double side, double radius, int cells) {
    double a[3];
    sort(xi, a);
    const int whole = inside(a, side, radius);
    return whole >= 0 ? whole : fraction_of_sorted(a, side, radius, cells);
}

/* Slots of the table; a new entry replaces an old one with the same hash. */
enum { PLACES = 1024, KEY = 6 };

struct solid_weight_table {
    struct {
        double key[KEY], fraction;
    } place[PLACES];
};

struct solid_weight_table *solid_weight_table_new(void) {
    return memory_new(MEMORY_SOLID, 1, sizeof(struct solid_weight_table));
}

void solid_weight_table_free(struct solid_weight_table *table) { memory_free(table); }

double solid_weight_fraction_kept(struct solid_weight_table *table, const double xi[3], double side, double radius,
                                  int cells) {
    double key[KEY] = {[3] = side, [4] = radius, [5] = cells};
    sort(xi, key);
    const int whole = inside(key, side, radius);
    if (whole >= 0) return whole;
    uint64_t hash = 0, word;
    for (int k = 0; k < KEY; k++) {
        memcpy(&word, &key[k], sizeof word);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    const int at = (int)(hash % PLACES);
    if (memcmp(table->place[at].key, key, sizeof key) != 0) {
        memcpy(table->place[at].key, key, sizeof key);
        table->place[at].fraction = fraction_of_sorted(key, side, radius, cells);
    }
    return table->place[at].fraction;
}

static double fraction_of_step(const struct solid_stencil *t, const int step[3]) {
    /* the fraction is equal for all permutations and signs: checks whether it is known already */
    for (int o = 0; o < t->n; o++) {
        const int *other = t->offset[o].step;
        const int same2 = other[0] * other[0] + other[1] * other[1] + other[2] * other[2] ==
                          step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
        const int same4 = other[0] * other[0] * other[1] * other[1] * other[2] * other[2] ==
                          step[0] * step[0] * step[1] * step[1] * step[2] * step[2];
        const int sum = abs(other[0]) + abs(other[1]) + abs(other[2]);
        if (same2 && same4 && sum == abs(step[0]) + abs(step[1]) + abs(step[2]))
            return t->offset[o].weight / (t->spacing * t->spacing * t->spacing);
    }
    const double xi[3] = {step[0], step[1], step[2]};
    return solid_weight_fraction(xi, 1, t->horizon / t->spacing, CELLS);
}

struct solid_stencil *solid_weight_stencil_new(double spacing, double m) {
    struct solid_stencil *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    t->spacing = spacing;
    t->horizon = m * spacing;
    const double limit = (m + 0.5) * (m + 0.5) * (1 - 1e-12), volume = spacing * spacing * spacing;
    const int reach = (int)floor(m + 0.5);
    t->offset = memory_new(MEMORY_SOLID, SOLID_FAMILY_MAX, sizeof *t->offset);
    for (int k = -reach; k <= reach; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const int step2 = i * i + j * j + k * k;
                if (step2 == 0 || step2 >= limit) continue;
                if (t->n == SOLID_FAMILY_MAX)
                    die_all(EXIT_CODE_SCENE, "horizon_ratio = %g: a particle would have more than %d bonds", m,
                            SOLID_FAMILY_MAX);
                const int step[3] = {i, j, k};
                const double fraction = fraction_of_step(t, step);
                struct solid_offset *o = &t->offset[t->n++];
                for (int c = 0; c < 3; c++) {
                    o->step[c] = step[c];
                    o->xi[c] = step[c] * spacing;
                    if (abs(step[c]) > t->reach) t->reach = abs(step[c]);
                }
                o->length = sqrt(step2) * spacing;
                o->inv_length2 = 1 / (step2 * spacing * spacing);
                o->weight = fraction * volume;
                t->full_volume += o->weight;
            }
    return t;
}

void solid_weight_stencil_free(struct solid_stencil *t) {
    if (!t) return;
    memory_free(t->offset);
    memory_free(t);
}
