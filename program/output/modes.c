/* Writes modes.csv: azimuthal modes of the damage in rings about an axis during the run. */
#include "program/output/outputs.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/measure/damage.h"
#include "solid/measure/modes.h"

#include <string.h>

enum { STEP, T, RING, INNER, OUTER, PARTICLES, MODE, AMPLITUDE, ANGLE, COLUMNS };
struct modes {
    struct outputs_base base;
    const struct scene_modes *scene; /* borrowed */
    struct solid_rings rings;
    long *particles;         /* [rings], work */
    struct solid_mode *mode; /* [rings][highest + 1], work */
};

static void measure(struct modes *m, const struct solid *s) {
    double *damage = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *damage);
    solid_damage_measure(s, damage);
    solid_modes_measure(s, &m->rings, damage, m->particles, m->mode);
    memory_free(damage);
}

static int begin(void *self, struct run *r) {
    const struct scene_modes *scene = r->scene->output.modes;
    struct modes *m = self;
    if (!scene || !r->needs.bonds) return 0;
    m->base.every = scene->every;
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
    m->base.rows = m->rings.rings * (m->rings.highest + 1);
    return 1;
}

static void sample(void *self, struct run *r, const struct outputs_moment *moment) {
    struct modes *m = self;
    (void)moment;
    measure(m, r->solid);
    for (int q = 0; q < m->rings.rings; q++)
        for (int k = 0; k <= m->rings.highest; k++) {
            const struct solid_mode *is = &m->mode[q * (m->rings.highest + 1) + k];
            outputs_row(&m->base, r,
                        (double[COLUMNS]){[RING] = q,
                                          [INNER] = m->scene->radius[q],
                                          [OUTER] = m->scene->radius[q + 1],
                                          [PARTICLES] = (double)m->particles[q],
                                          [MODE] = k,
                                          [AMPLITUDE] = is->amplitude,
                                          [ANGLE] = is->angle});
        }
}

static void free_modes(void *self) {
    struct modes *m = self;
    MEMORY_FREE(m->particles, m->mode);
}

const struct output output_modes = {
    .file = {"modes.csv"},
    .columns = "step 1|t s|ring 1|inner m|outer m|particles 1|mode 1|amplitude 1|angle degrees",
    .bytes = sizeof(struct modes),
    .when = OUTPUTS_EVERY | OUTPUTS_STAGE,
    .begin = begin,
    .sample = sample,
    .free = free_modes,
};
