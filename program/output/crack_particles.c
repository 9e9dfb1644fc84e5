/* Writes crack_particles.csv: a row for each particle of a plate when it is first damaged. */
#include "program/output/crack_particles.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table_columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEP, T, X, Y, SIZE, COLUMNS };
/* The table has places of particles to 15 digits: the tolerance by which one is recognised, in spacings. */
static const double TOLERANCE = 1e-6;

struct crack_particles {
    struct table *table;
    long n, capacity;
    double (*seen)[2]; /* [n] places of the particles that have a row, sorted, m */
};

static int by_place(const void *a, const void *b) {
    const double *p = a, *q = b;
    const int k = p[0] == q[0];
    return (p[k] > q[k]) - (p[k] < q[k]);
}

static void add_seen(struct crack_particles *k, const double x[2]) {
    MEMORY_MORE(MEMORY_OUTPUT, k->seen, k->n, k->capacity);
    memcpy(k->seen[k->n++], x, sizeof *k->seen);
}

/* Whether one of the places, sorted, is x but for its last digits. */
static int contains(long n, const double (*place)[2], const double x[2], double same) {
    long low = 0, high = n;
    while (low < high) {
        const long middle = (low + high) / 2;
        if (place[middle][0] < x[0] - same)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < n && place[low][0] <= x[0] + same; low++)
        if (fabs(place[low][1] - x[1]) <= same) return 1;
    return 0;
}

/* Marks the damaged particles that have a row in the table as seen, at their exact places. */
static void mark_written(struct crack_particles *k, const char *path, const struct solid_crack_particles *damaged,
                         double same) {
    struct table_data *d = par_rank() == 0 ? table_read(path, NULL) : NULL;
    long rows = d ? d->rows : 0;
    par_bcast(&rows, sizeof rows, 0);
    double(*place)[2] = memory_new(MEMORY_OUTPUT, (size_t)rows + 1, sizeof *place);
    for (long i = 0; d && i < rows; i++) memcpy(place[i], d->value + i * COLUMNS + X, sizeof *place);
    table_read_free(d);
    par_bcast(place, (size_t)rows * sizeof *place, 0);
    qsort(place, (size_t)rows, sizeof *place, by_place);
    for (long i = 0; i < damaged->n; i++)
        if (contains(rows, (const double(*)[2])place, damaged->x[i], same)) add_seen(k, damaged->x[i]);
    qsort(k->seen, (size_t)k->n, sizeof *k->seen, by_place);
    memory_free(place);
}

struct crack_particles *crack_particles_new(const char *folder, const struct solid_crack_particles *damaged,
                                            double spacing, long resume_step) {
    char path[FOLDER_PATH];
    struct crack_particles *k = memory_new(MEMORY_OUTPUT, 1, sizeof *k);
    k->capacity = 64;
    k->seen = memory_new(MEMORY_OUTPUT, (size_t)k->capacity, sizeof *k->seen);
    k->table = table_columns_new(folder, "crack_particles.csv", "step 1|t s|x m|y m|size m", 2, resume_step);
    if (resume_step >= 0)
        mark_written(k, folder_path(path, folder, "crack_particles.csv"), damaged, TOLERANCE * spacing);
    return k;
}

void crack_particles_sample(struct crack_particles *k, const struct solid_crack_particles *damaged, long step,
                            double t) {
    const long before = k->n;
    for (long i = 0; i < damaged->n; i++) {
        const double *x = damaged->x[i];
        if (bsearch(x, k->seen, (size_t)before, sizeof *k->seen, by_place)) continue;
        const double row[COLUMNS] = {(double)step, t, x[0], x[1], damaged->size[i]};
        table_add(k->table, row);
        add_seen(k, x);
    }
    table_flush(k->table);
    if (k->n > before) qsort(k->seen, (size_t)k->n, sizeof *k->seen, by_place);
}

void crack_particles_free(struct crack_particles *k) {
    if (!k) return;
    table_free(k->table);
    MEMORY_FREE(k->seen, k);
}
