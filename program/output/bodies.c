/* Writes bodies.csv: mass, momentum, kinetic energy, displacement and contact's force of each body during the run. */
#include "program/output/outputs.h"
#include "program/output/amount.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "solid/measure/motion.h"

#include <stdlib.h>
#include <string.h>

enum { STEP, T, BODY, MASS, KINETIC, FIRST, COLUMNS_MAX = FIRST + 9 };

struct bodies {
    struct table *table;
    int dim, n;
    struct solid_motion *now; /* [n], work */
};

static void *new (struct run *r) {
    if (!r->needs.bonds || !r->scene->output.bodies || r->scene->output.series_every == 0) return NULL;
    if (r->solid->in.bodies < 2) return NULL;
    struct bodies *b = calloc(1, sizeof *b);
    ENSURE(b, "no memory for bodies");
    b->dim = r->solid->dim;
    b->n = r->solid->in.bodies;
    b->now = calloc((size_t)b->n, sizeof *b->now);
    ENSURE(b->now, "no memory for %d bodies", b->n);
    return b;
}

static void write(struct bodies *b, const struct run *r) {
    clock_begin(CLOCK_OUTPUT);
    solid_motion_measure(r->solid, b->now);
    for (int k = 0; k < b->n; k++) {
        const struct solid_motion *m = &b->now[k];
        double row[COLUMNS_MAX] = {
            [STEP] = (double)r->step, [T] = r->t, [BODY] = k, [MASS] = m->mass, [KINETIC] = m->kinetic};
        for (int c = 0; c < b->dim; c++) {
            row[FIRST + c] = m->momentum[c];
            row[FIRST + b->dim + c] = m->displacement[c];
            row[FIRST + 2 * b->dim + c] = m->contact[c];
        }
        table_row(b->table, row);
    }
    clock_end(CLOCK_OUTPUT);
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct bodies *b = self;
    static const char *const part[] = {"momentum_", "displacement_", "contact_"}, *const part_unit[] = {"N s", "m",
                                                                                                        "N"};
    char path[FOLDER_PATH], text[9][20];
    const char *name[COLUMNS_MAX] = {"step", "t", "body", "mass", "e_kinetic"};
    const char *unit[COLUMNS_MAX] = {"1", "s", "1", "kg", "J"};
    int n = FIRST;
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < b->dim; c++, n++) {
            strcat(strcpy(text[n - FIRST], part[k]), (char[]){"xyz"[c], '\0'});
            name[n] = text[n - FIRST];
            unit[n] = part_unit[k];
        }
    b->table = table_new(folder_path(path, folder, "bodies.csv"), n, name, unit, resume_step);
    if (resume_step < 0) write(b, r);
}

/* Only after a step that has moved the solid. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    if (r->moved == r->step) write(self, r);
}

static double numbers(const void *self, const struct run *r, long steps) {
    const struct bodies *b = self;
    return (double)amount_samples(r, r->scene->output.series_every, 0, steps) * b->n * (FIRST + 3 * b->dim);
}

static void free_bodies(void *self) {
    struct bodies *b = self;
    table_free(b->table);
    free(b->now);
    free(b);
}

const struct output output_bodies = {
    .file = {"bodies.csv"}, .new = new, .open = open, .sample = sample, .free = free_bodies, .numbers = numbers};
