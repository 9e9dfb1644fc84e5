/* Writes fluid_probes.csv: velocity and pressure at given points and along lines during the run. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table.h"

#include <stdlib.h>
#include <string.h>

enum { STEP, T, PROBE, PLACE, VALUE = PLACE + 3, COLUMNS = VALUE + 4 };

struct fluid_probes {
    long every;
    int n;
    double (*at)[3]; /* [n] m: single points, then those of the lines */
    struct table *table;
    double (*value)[4]; /* [n] u, v, w, p, work */
};

static void places_of(const struct scene_fluid_probes *scene, double (*at)[3]) {
    for (int k = 0; k < scene->places; k++) memcpy(at[k], scene->at[k], sizeof at[k]);
    at += scene->places;
    for (int l = 0; l < scene->lines; l++) {
        const struct scene_probe_line *line = &scene->line[l];
        for (int k = 0; k < line->points; k++, at++)
            for (int c = 0; c < 3; c++) {
                const double part = (double)k / (line->points - 1);
                (*at)[c] = (1 - part) * line->from[c] + part * line->to[c]; /* weighted so that rounding cannot pass the
                                                                             * ends */
            }
    }
}

static void *new (struct run *r) {
    const struct scene_fluid_probes *scene = r->scene->output.fluid_probes;
    if (!scene) return NULL;
    struct fluid_probes *p = calloc(1, sizeof *p);
    ENSURE(p, "no memory for probes");
    p->every = scene->every;
    p->n = scene->places;
    for (int l = 0; l < scene->lines; l++) p->n += scene->line[l].points;
    p->at = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *p->at);
    p->value = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *p->value);
    places_of(scene, p->at);
    return p;
}

/* Appends a row for each point. */
static void write(struct fluid_probes *p, struct run *r) {
    clock_begin(CLOCK_OUTPUT);
    fluid_state_refresh(r->fluid);
    for (int k = 0; k < p->n; k++) fluid_value_at(r->fluid, p->at[k], p->value[k]);
    par_sum_array(&p->value[0][0], 4 * p->n);
    for (int k = 0; k < p->n; k++) {
        double row[COLUMNS] = {[STEP] = (double)r->step, [T] = r->t, [PROBE] = k};
        memcpy(row + PLACE, p->at[k], sizeof p->at[k]);
        memcpy(row + VALUE, p->value[k], sizeof p->value[k]);
        table_add(p->table, row);
    }
    table_flush(p->table);
    clock_end(CLOCK_OUTPUT);
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct fluid_probes *p = self;
    static const char *const name[COLUMNS] = {"step", "t", "probe", "x", "y", "z", "u", "v", "w", "p"},
                             *const unit[COLUMNS] = {"1", "s", "1", "m", "m", "m", "m/s", "m/s", "m/s", "Pa"};
    char path[FOLDER_PATH];
    p->table = table_new(folder_path(path, folder, "fluid_probes.csv"), COLUMNS, name, unit, resume_step);
    if (resume_step < 0) write(p, r);
}

static int due(const void *self, const struct outputs_moment *m) {
    return m->step % ((const struct fluid_probes *)self)->every == 0;
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    write(self, r);
}

static double numbers(const void *self, const struct run *r, long steps) {
    const struct fluid_probes *p = self;
    (void)r;
    return (double)steps / (double)p->every * p->n * COLUMNS;
}

static void free_probes(void *self) {
    struct fluid_probes *p = self;
    table_free(p->table);
    memory_free(p->at);
    memory_free(p->value);
    free(p);
}

const struct output output_fluid_probes = {.file = {"fluid_probes.csv"},
                                           .new = new,
                                           .open = open,
                                           .due = due,
                                           .sample = sample,
                                           .free = free_probes,
                                           .numbers = numbers};
