/* The largest speed of the tips of cracks that a fluid drives, and a warning where inertia counts. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "base/files/log.h"
#include "physics/growth.h"

#include <math.h>

/* Spacings over which a speed is taken, and the part of sqrt(E/rho) above which inertia counts. */
#define ADVANCE 5
#define SLOW 0.05

struct crack_speed {
    struct outputs_base base;
    double advance, wave, most; /* m; sqrt(E/rho) and the largest speed so far, m/s */
    long n, capacity, first;
    double *t, *length; /* [n] s; of a crack with two tips, in space the radius of a circular one, m */
};

static int begin(void *self, struct run *r) {
    struct crack_speed *c = self;
    if (!r->cracks) return 0;
    const struct scene_solid *s = r->scene->solid;
    const struct scene_material *m = &s->material[s->body[0].material_index];
    c->advance = ADVANCE * r->solid->in.spacing;
    c->wave = sqrt(m->youngs_modulus / m->density);
    return 1;
}

/* A warning after the first speed at which inertia counts. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct crack_speed *c = self;
    const double area = m->found->series.cracks.area;
    if (c->n == c->capacity) {
        c->capacity = 2 * c->capacity + 64;
        c->t = memory_grown(MEMORY_OUTPUT, c->t, (size_t)c->n, (size_t)c->capacity, sizeof *c->t);
        c->length = memory_grown(MEMORY_OUTPUT, c->length, (size_t)c->n, (size_t)c->capacity, sizeof *c->length);
    }
    c->t[c->n] = r->t;
    c->length[c->n] = r->solid->dim == 2 ? 0.5 * area / r->solid->in.thickness : sqrt(area / acos(-1));
    const double speed = physics_growth_speed(c->t, c->length, c->n++, c->advance, &c->first);
    if (speed > SLOW * c->wave && !(c->most > SLOW * c->wave))
        log_line(
            "warning: crack fluid: the tips run at %.3g m/s, %.3g sqrt(E/rho_s), over %d spacings: above %g inertia "
            "counts",
            speed, speed / c->wave, ADVANCE, SLOW);
    c->most = fmax(c->most, speed);
}

/* A line on the largest speed, if the tips have run five spacings. */
static void report(const void *self, const struct run *r) {
    const struct crack_speed *c = self;
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (!stage->crack_fluid || !(c->most > 0)) return;
    log_line("stage %s: crack fluid: tips at up to %.3g m/s, %.3g sqrt(E/rho_s), over %d spacings", stage->name,
             c->most, c->most / c->wave, ADVANCE);
}

static void free_crack_speed(void *self) {
    struct crack_speed *c = self;
    MEMORY_FREE(c->t, c->length);
}

const struct output output_crack_speed = {
    .bytes = sizeof(struct crack_speed), .begin = begin, .sample = sample, .report = report, .free = free_crack_speed};
