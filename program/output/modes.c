/* Writes modes.csv: azimuthal modes of the damage in rings about an axis during the run. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "solid/measure/damage.h"
#include "solid/measure/modes.h"

#include <stdlib.h>
#include <string.h>

enum { STEP, T, RING, INNER, OUTER, PARTICLES, MODE, AMPLITUDE, ANGLE, COLUMNS };
static const char *const name[COLUMNS] = {"step",      "t",    "ring",      "inner", "outer",
                                          "particles", "mode", "amplitude", "angle"};
static const char *const unit[COLUMNS] = {"1", "s", "1", "m", "m", "1", "1", "1", "degrees"};

struct modes {
    const struct scene_modes *scene; /* borrowed */
    struct solid_rings rings;
    long *particles;         /* [rings], work */
    struct solid_mode *mode; /* [rings][highest + 1], work */
    struct table *table;
};

static void measure(struct modes *m, const struct solid *s) {
    double *damage = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *damage);
    solid_damage_measure(s, damage);
    solid_modes_measure(s, &m->rings, damage, m->particles, m->mode);
    memory_free(damage);
}

static void *new (struct run *r) {
    const struct scene_modes *scene = r->scene->output.modes;
    if (!scene || !r->needs.bonds) return NULL;
    struct modes *m = calloc(1, sizeof *m);
    ENSURE(m, "no memory for modes");
    m->scene = scene;
    m->rings = (struct solid_rings){.rings = scene->radii - 1, .highest = scene->highest, .radius = scene->radius};
    memcpy(m->rings.centre, scene->centre, sizeof scene->centre);
    solid_modes_across(r->scene->dimension == 2 ? (const double[3]){0, 0, 1} : scene->axis, m->rings.across);
    m->particles = memory_new(MEMORY_OUTPUT, (size_t)m->rings.rings, sizeof *m->particles);
    m->mode = memory_new(MEMORY_OUTPUT, (size_t)(m->rings.rings * (m->rings.highest + 1)), sizeof *m->mode);
    measure(m, r->solid);
    for (int q = 0; q < m->rings.rings; q++)
        if (m->particles[q] == 0)
            die_all(EXIT_CODE_SCENE, "%s: output.modes.radii: no particle stands between %g and %g m from the axis",
                    r->scene->path, scene->radius[q], scene->radius[q + 1]);
    return m;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct modes *m = self;
    char path[FOLDER_PATH];
    (void)r;
    m->table = table_new(folder_path(path, folder, "modes.csv"), COLUMNS, name, unit, resume_step);
}

static int due(const void *self, const struct outputs_moment *moment) {
    const struct modes *m = self;
    return moment->step % m->scene->every == 0 || moment->stage_ends;
}

static void sample(void *self, struct run *r, const struct outputs_moment *moment) {
    struct modes *m = self;
    (void)moment;
    clock_begin(CLOCK_OUTPUT);
    measure(m, r->solid);
    for (int q = 0; q < m->rings.rings; q++)
        for (int k = 0; k <= m->rings.highest; k++) {
            const struct solid_mode *is = &m->mode[q * (m->rings.highest + 1) + k];
            table_add(m->table, (const double[COLUMNS]){[STEP] = (double)r->step,
                                                        [T] = r->t,
                                                        [RING] = q,
                                                        [INNER] = m->scene->radius[q],
                                                        [OUTER] = m->scene->radius[q + 1],
                                                        [PARTICLES] = (double)m->particles[q],
                                                        [MODE] = k,
                                                        [AMPLITUDE] = is->amplitude,
                                                        [ANGLE] = is->angle});
        }
    table_flush(m->table);
    clock_end(CLOCK_OUTPUT);
}

static double numbers(const void *self, const struct run *r, long steps) {
    const struct modes *m = self;
    (void)r;
    return (double)steps / (double)m->scene->every * m->rings.rings * (m->rings.highest + 1) * COLUMNS;
}

static void free_modes(void *self) {
    struct modes *m = self;
    table_free(m->table);
    memory_free(m->particles);
    memory_free(m->mode);
    free(m);
}

const struct output output_modes = {.file = {"modes.csv"},
                                    .new = new,
                                    .open = open,
                                    .due = due,
                                    .sample = sample,
                                    .free = free_modes,
                                    .numbers = numbers};
