/* Writes bodies.csv: mass, momentum, kinetic energy, displacement and contact's force of each body during the run. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "solid/contact/contact.h"
#include "solid/measure/motion.h"

enum { STEP, T, BODY, MASS, KINETIC, FIRST, COLUMNS_MAX = FIRST + 9 };

struct bodies {
    struct outputs_base base;
    struct solid_motion *now; /* [bodies], work */
};

static int begin(void *self, struct run *r) {
    struct bodies *b = self;
    if (!r->needs.bonds || !r->scene->output.bodies || r->scene->output.series_every == 0) return 0;
    if (r->solid->in.bodies < 2) return 0;
    b->base.rows = r->solid->in.bodies;
    b->now = memory_new(MEMORY_OUTPUT, (size_t)r->solid->in.bodies, sizeof *b->now);
    return 1;
}

/* Only after a step that has moved the solid. */
static void sample(void *self, struct run *r, const struct outputs_moment *now) {
    struct bodies *b = self;
    if (r->moved != r->step && !now->first) return;
    const int dim = r->solid->dim;
    if (now->first) solid_contact_update(r->solid); /* else the step has done so */
    solid_motion_measure(r->solid, b->now);
    for (int k = 0; k < r->solid->in.bodies; k++) {
        const struct solid_motion *m = &b->now[k];
        double row[COLUMNS_MAX] = {[BODY] = k, [MASS] = m->mass, [KINETIC] = m->kinetic};
        for (int c = 0; c < dim; c++) {
            row[FIRST + c] = m->momentum[c];
            row[FIRST + dim + c] = m->displacement[c];
            row[FIRST + 2 * dim + c] = m->contact[c];
        }
        outputs_row(&b->base, r, row);
    }
}

static void free_bodies(void *self) { memory_free(((struct bodies *)self)->now); }

const struct output output_bodies = {
    .file = {"bodies.csv"},
    .columns = "step 1|t s|body 1|mass kg|e_kinetic J|momentum_* N s|displacement_* m|contact_* N",
    .bytes = sizeof(struct bodies),
    .begin = begin,
    .first = 1,
    .sample = sample,
    .free = free_bodies,
};
