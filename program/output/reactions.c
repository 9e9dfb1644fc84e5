/* Writes reactions.csv: force and mean displacement of every constraint, load and indenter during the run. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "solid/imposed/reactions.h"

enum { STEP, T, LOAD, INDEX, PARTICLES, FORCE, COLUMNS_MAX = FORCE + 6 };

struct reactions {
    struct outputs_base base;
    int constraints, loads, all;
    struct solid_reaction *now; /* [all], work */
};

static int begin(void *self, struct run *r) {
    struct reactions *a = self;
    if (!r->needs.bonds || !r->scene->output.reactions || r->scene->output.series_every == 0) return 0;
    const struct solid_input *in = &r->solid->in;
    a->constraints = in->constraints;
    a->loads = in->loads;
    a->all = in->constraints + in->loads + in->indenters;
    if (a->all == 0) return 0;
    a->base.rows = a->all;
    a->now = memory_new(MEMORY_OUTPUT, (size_t)a->all, sizeof *a->now);
    solid_reactions_new(r->solid);
    return 1;
}

/* Only after a step that has moved the solid. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct reactions *a = self;
    (void)m;
    if (r->moved != r->step) return;
    const int dim = r->solid->dim;
    solid_reactions_measure(r->solid, a->now);
    for (int k = 0; k < a->all; k++) {
        const int kind = (k >= a->constraints) + (k >= a->constraints + a->loads);
        const int before = kind == 0 ? 0 : kind == 1 ? a->constraints : a->constraints + a->loads;
        double row[COLUMNS_MAX] = {[LOAD] = kind, [INDEX] = k - before, [PARTICLES] = (double)a->now[k].particles};
        for (int c = 0; c < dim; c++) {
            row[FORCE + c] = a->now[k].force[c];
            row[FORCE + dim + c] = a->now[k].displacement[c];
        }
        outputs_row(&a->base, r, row);
    }
}

static void free_reactions(void *self) { memory_free(((struct reactions *)self)->now); }

const struct output output_reactions = {
    .file = {"reactions.csv"},
    .columns = "step 1|t s|load 1|index 1|particles 1|force_* N|displacement_* m",
    .bytes = sizeof(struct reactions),
    .begin = begin,
    .sample = sample,
    .free = free_reactions,
};
