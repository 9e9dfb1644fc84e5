/* Writes fluid_probes.csv: velocity and pressure at given points and along lines during the run. */
#include "program/output/fluid_probes.h"
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

struct fluid_probes *fluid_probes_new(struct run *r) {
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

void fluid_probes_open(struct fluid_probes *p, struct run *r, const char *folder, long resume_step) {
    static const char *const name[COLUMNS] = {"step", "t", "probe", "x", "y", "z", "u", "v", "w", "p"},
                             *const unit[COLUMNS] = {"1", "s", "1", "m", "m", "m", "m/s", "m/s", "m/s", "Pa"};
    char path[FOLDER_PATH];
    p->table = table_new(folder_path(path, folder, "fluid_probes.csv"), COLUMNS, name, unit, resume_step);
    if (resume_step < 0) fluid_probes_sample(p, r);
}

int fluid_probes_are_due(const struct fluid_probes *p, long step) { return p && step % p->every == 0; }

void fluid_probes_sample(struct fluid_probes *p, struct run *r) {
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

void fluid_probes_free(struct fluid_probes *p) {
    if (!p) return;
    table_free(p->table);
    memory_free(p->at);
    memory_free(p->value);
    free(p);
}
