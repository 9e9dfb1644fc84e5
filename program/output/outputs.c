/* Calls the outputs of a run in the order of their table. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/files/folder.h"
#include "base/files/table_columns.h"
#include "base/files/table_rows.h"
#include "program/output/amount.h"

#include <stdlib.h>

static const struct output *const kind[] = {
#define LINE(name) &output_##name,
    OUTPUTS(LINE)
#undef LINE
};
enum { KINDS = sizeof kind / sizeof *kind };

struct outputs {
    struct outputs_found found;
    struct outputs_base *self[KINDS]; /* NULL: the scene does not ask for it */
};

void outputs_own_files(void) {
    for (int k = 0; k < KINDS; k++)
        for (const char *const *file = kind[k]->file; *file; file++) folder_own(*file);
}

static int dimension_of(const struct run *r) { return r->solid ? r->solid->dim : 3; }

/* Rows that have been added are in the file. */
static void flush(struct outputs_base *self) {
    if (self->table) table_flush(self->table);
}

/* The output's struct; NULL: the scene does not ask for it. */
static struct outputs_base *begin(const struct output *a, struct run *r) {
    struct outputs_base *self = calloc(1, a->bytes);
    ENSURE(self, "no memory for %s", a->file[0] ? a->file[0] : "an output");
    if (a->columns) self->columns = table_columns_count(a->columns, dimension_of(r));
    if (a->begin(self, r)) return self;
    free(self);
    return NULL;
}

struct outputs *outputs_new(struct run *r) {
    struct outputs *o = calloc(1, sizeof *o);
    ENSURE(o, "no memory for outputs");
    o->found.fragments = o->found.largest_fragment = -1;
    for (int k = 0; k < KINDS; k++) o->self[k] = begin(kind[k], r);
    return o;
}

/* Dies unless each table that is continued has the rows that it had at the checkpoint, before any file is changed. */
static void require_rows(const struct outputs *o, const char *folder, long resume_step) {
    char path[FOLDER_PATH];
    for (int k = 0; k < KINDS; k++)
        for (const char *const *file = kind[k]->file; o->self[k] && *file; file++) {
            const char *misses = table_rows_check(folder_path(path, folder, *file), resume_step);
            if (misses)
                die_all(EXIT_CODE_FILE,
                        "%s: %s: the checkpoint can be resumed in another folder, by --resume=FILE --out DIR", path,
                        misses);
        }
}

void outputs_open(struct outputs *o, struct run *r, const char *folder, long resume_step) {
    if (resume_step >= 0) require_rows(o, folder, resume_step);
    for (int k = 0; k < KINDS; k++) {
        const struct output *a = kind[k];
        if (!o->self[k]) continue;
        if (a->columns)
            o->self[k]->table = table_columns_new(folder, a->file[0], a->columns, dimension_of(r), resume_step);
        if (a->open) a->open(o->self[k], r, folder, resume_step);
        const struct outputs_moment m = {.step = r->step, .first = 1, .found = &o->found};
        if (a->first && resume_step < 0) a->sample(o->self[k], r, &m);
        flush(o->self[k]);
    }
}

void outputs_prepare(struct outputs *o, struct run *r) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->prepare) kind[k]->prepare(o->self[k], r);
}

static int when_of(const struct output *a) { return a->when ? a->when : OUTPUTS_SERIES; }

static int is_due(const struct output *a, const struct outputs_base *self, const struct outputs_moment *m) {
    const int when = when_of(a);
    return (when & OUTPUTS_SERIES && m->series_due) || (when & OUTPUTS_FIELDS && m->fields_due) ||
           (when & OUTPUTS_STAGE && m->stage_ends) || (when & OUTPUTS_EVERY && m->step % self->every == 0);
}

void outputs_sample(struct outputs *o, struct run *r, int series_due, int fields_due, int stage_ends) {
    const struct outputs_moment m = {r->step, series_due, fields_due, stage_ends, 0, &o->found};
    clock_begin(CLOCK_SERIES);
    for (int k = 0; k < KINDS; k++) {
        if (!o->self[k]) continue;
        if (is_due(kind[k], o->self[k], &m)) {
            kind[k]->sample(o->self[k], r, &m);
            flush(o->self[k]);
        } else if (kind[k]->cancel)
            kind[k]->cancel(o->self[k], r);
    }
    clock_end(CLOCK_SERIES);
}

enum signals_reason outputs_stopped(const struct outputs *o) { return o->found.stopped; }

void outputs_flush(struct outputs *o, struct run *r) {
    clock_begin(CLOCK_OUTPUT);
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->flush) {
            kind[k]->flush(o->self[k], r);
            flush(o->self[k]);
        }
    clock_end(CLOCK_OUTPUT);
}

void outputs_report(const struct outputs *o, const struct run *r) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->report) kind[k]->report(o->self[k], r);
}

double outputs_numbers(const struct outputs *o, const struct run *r, long steps) {
    double sum = 0;
    for (int k = 0; k < KINDS; k++) {
        const struct outputs_base *self = o->self[k];
        if (!self) continue;
        const int when = when_of(kind[k]);
        const long every = when & OUTPUTS_EVERY ? self->every : r->scene->output.series_every;
        const double samples =
            when == OUTPUTS_EVERY ? (double)steps / (double)every : (double)amount_samples(r, every, 0, steps);
        sum += samples * self->rows * self->columns;
    }
    return sum;
}

const struct series_sample *outputs_last(const struct outputs *o) { return &o->found.series; }

void outputs_free(struct outputs *o) {
    if (!o) return;
    for (int k = 0; k < KINDS; k++) {
        if (!o->self[k]) continue;
        if (kind[k]->free) kind[k]->free(o->self[k]);
        table_free(o->self[k]->table);
        free(o->self[k]);
    }
    free(o);
}
