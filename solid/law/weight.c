/* Partial volumes of cubic cells in the horizon's sphere.  (001: sec. 3.3.5) */
#include "solid/law/weight.h"
#include "base/memory.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Columns are along the largest component of a, on cells x cells points of the face; the length of each column inside
 * the sphere is exact. */
static double fraction_of_sorted(const double a[3], double side, double radius, int cells) {
    const double low = a[2] - side / 2, high = a[2] + side / 2;
    double sum = 0;
    for (int j = 0; j < cells; j++) {
        const double y = a[1] + side * ((j + 0.5) / cells - 0.5);
        for (int i = 0; i < cells; i++) {
            const double x = a[0] + side * ((i + 0.5) / cells - 0.5);
            const double h2 = radius * radius - x * x - y * y;
            if (h2 <= 0) continue;
            const double h = sqrt(h2);
            const double column = (high < h ? high : h) - (low > -h ? low : -h);
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

double solid_weight_fraction_cached(struct solid_weight_table *table, const double xi[3], double side, double radius,
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
