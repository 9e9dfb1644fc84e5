/* The largest speed of the tips of cracks that a fluid drives, and a warning where inertia counts. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "base/files/log.h"
#include "physics/growth.h"

#include <math.h>
#include <string.h>

/* Spacings over which a speed is taken, and the part of sqrt(E/rho) above which inertia counts. */
#define ADVANCE 5
#define SLOW 0.05

struct crack_speed {
    double advance, wave, most; /* m; sqrt(E/rho) and the largest speed so far, m/s */
    long n, capacity, first;
    double *t, *length; /* [n] s; of a crack with two tips, in space the radius of a circular one, m */
};

static void *new (struct run *r) {
    if (!r->cracks) return NULL;
    struct crack_speed *c = memory_new(MEMORY_OUTPUT, 1, sizeof *c);
    const struct scene_solid *s = r->scene->solid;
    const struct scene_material *m = &s->material[s->body[0].material_index];
    *c = (struct crack_speed){.advance = ADVANCE * r->solid->in.spacing, .wave = sqrt(m->youngs_modulus / m->density)};
    return c;
}

static double *longer(double *from, long n, long capacity) {
    double *to = memory_new(MEMORY_OUTPUT, (size_t)capacity, sizeof *to);
    if (n > 0) memcpy(to, from, (size_t)n * sizeof *to);
    memory_free(from);
    return to;
}

/* A warning after the first speed at which inertia counts. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct crack_speed *c = self;
    const double area = m->found->series.crack_area_wet;
    if (c->n == c->capacity) {
        c->capacity = 2 * c->capacity + 64;
        c->t = longer(c->t, c->n, c->capacity);
        c->length = longer(c->length, c->n, c->capacity);
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
    memory_free(c->t);
    memory_free(c->length);
    memory_free(c);
}

const struct output output_crack_speed = {.new = new, .sample = sample, .report = report, .free = free_crack_speed};
