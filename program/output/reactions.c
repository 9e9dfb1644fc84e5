/* Writes reactions.csv: force and mean displacement of every constraint, load and indenter during the run. */
#include "program/output/outputs.h"
#include "program/output/amount.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "solid/imposed/reactions.h"

#include <stdlib.h>
#include <string.h>

enum { STEP, T, LOAD, INDEX, PARTICLES, FORCE, COLUMNS_MAX = FORCE + 6 };

struct reactions {
    struct table *table;
    int dim, constraints, loads, all;
    struct solid_reaction *now; /* [all], work */
};

static void *new (struct run *r) {
    const struct scene *scene = r->scene;
    if (!r->needs.bonds || !scene->output.reactions || scene->output.series_every == 0) return NULL;
    const struct solid_input *in = &r->solid->in;
    if (in->constraints + in->loads + in->indenters == 0) return NULL;
    struct reactions *a = calloc(1, sizeof *a);
    ENSURE(a, "no memory for reactions");
    a->dim = r->solid->dim;
    a->constraints = in->constraints;
    a->loads = in->loads;
    a->all = in->constraints + in->loads + in->indenters;
    a->now = calloc((size_t)a->all, sizeof *a->now);
    ENSURE(a->now, "no memory for %d reactions", a->all);
    solid_reactions_new(r->solid);
    return a;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct reactions *a = self;
    static const char letter[] = "xyz";
    char path[FOLDER_PATH], text[6][20];
    const char *name[COLUMNS_MAX] = {"step", "t", "load", "index", "particles"};
    const char *unit[COLUMNS_MAX] = {"1", "s", "1", "1", "1"};
    int n = FORCE;
    (void)r;
    for (int c = 0; c < 2 * a->dim; c++, n++) {
        strcat(strcpy(text[c], c < a->dim ? "force_" : "displacement_"), (char[]){letter[c % a->dim], '\0'});
        name[n] = text[c];
        unit[n] = c < a->dim ? "N" : "m";
    }
    a->table = table_new(folder_path(path, folder, "reactions.csv"), n, name, unit, resume_step);
}

/* Only after a step that has moved the solid. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct reactions *a = self;
    (void)m;
    if (r->moved != r->step) return;
    clock_begin(CLOCK_OUTPUT);
    solid_reactions_measure(r->solid, a->now);
    for (int k = 0; k < a->all; k++) {
        const int kind = (k >= a->constraints) + (k >= a->constraints + a->loads);
        const int before = kind == 0 ? 0 : kind == 1 ? a->constraints : a->constraints + a->loads;
        double row[COLUMNS_MAX] = {[STEP] = (double)r->step,
                                   [T] = r->t,
                                   [LOAD] = kind,
                                   [INDEX] = k - before,
                                   [PARTICLES] = (double)a->now[k].particles};
        for (int c = 0; c < a->dim; c++) {
            row[FORCE + c] = a->now[k].force[c];
            row[FORCE + a->dim + c] = a->now[k].displacement[c];
        }
        table_row(a->table, row);
    }
    clock_end(CLOCK_OUTPUT);
}

static double numbers(const void *self, const struct run *r, long steps) {
    const struct reactions *a = self;
    return (double)amount_samples(r, r->scene->output.series_every, 0, steps) * a->all * (FORCE + 2 * a->dim);
}

static void free_reactions(void *self) {
    struct reactions *a = self;
    table_free(a->table);
    free(a->now);
    free(a);
}

const struct output output_reactions = {
    .file = {"reactions.csv"}, .new = new, .open = open, .sample = sample, .free = free_reactions, .numbers = numbers};
