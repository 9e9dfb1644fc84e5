/* Writes fluid_probes.csv: velocity and pressure at given points and along lines during the run. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "base/par.h"

#include <string.h>

enum { STEP, T, PROBE, PLACE, VALUE = PLACE + 3, COLUMNS = VALUE + 4 };

struct fluid_probes {
    struct outputs_base base;
    int n;
    double (*at)[3];    /* [n] m: single points, then those of the lines */
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

static int begin(void *self, struct run *r) {
    const struct scene_fluid_probes *scene = r->scene->output.fluid_probes;
    struct fluid_probes *p = self;
    if (!scene) return 0;
    p->base.every = scene->every;
    p->n = scene->places;
    for (int l = 0; l < scene->lines; l++) p->n += scene->line[l].points;
    p->at = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *p->at);
    p->value = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *p->value);
    p->base.rows = p->n;
    places_of(scene, p->at);
    return 1;
}

/* Appends a row for each point. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct fluid_probes *p = self;
    (void)m;
    fluid_value_at_points(r->fluid, p->n, (const double(*)[3])p->at, p->value);
    par_sum_array(&p->value[0][0], 4 * p->n);
    for (int k = 0; k < p->n; k++) {
        double row[COLUMNS] = {[PROBE] = k};
        memcpy(row + PLACE, p->at[k], sizeof p->at[k]);
        memcpy(row + VALUE, p->value[k], sizeof p->value[k]);
        outputs_row(&p->base, r, row);
    }
}

static void free_probes(void *self) {
    struct fluid_probes *p = self;
    MEMORY_FREE(p->at, p->value);
}

const struct output output_fluid_probes = {
    .file = {"fluid_probes.csv"},
    .columns = "step 1|t s|probe 1|x m|y m|z m|u m/s|v m/s|w m/s|p Pa",
    .bytes = sizeof(struct fluid_probes),
    .when = OUTPUTS_EVERY,
    .begin = begin,
    .first = 1,
    .sample = sample,
    .free = free_probes,
};
