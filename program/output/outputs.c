/* Calls the outputs of a run in the order of their table. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/files/folder.h"

#include <stdlib.h>

static const struct output *const kind[] = {
#define LINE(name) &output_##name,
    OUTPUTS(LINE)
#undef LINE
};
enum { KINDS = sizeof kind / sizeof *kind };

struct outputs {
    struct outputs_found found;
    void *self[KINDS]; /* NULL: the scene does not ask for it */
};

void outputs_own_files(void) {
    for (int k = 0; k < KINDS; k++)
        for (const char *const *file = kind[k]->file; *file; file++) folder_own(*file);
}

struct outputs *outputs_new(struct run *r) {
    struct outputs *o = calloc(1, sizeof *o);
    ENSURE(o, "no memory for outputs");
    o->found.fragments = o->found.largest_fragment = -1;
    for (int k = 0; k < KINDS; k++) o->self[k] = kind[k]->new (r);
    return o;
}

void outputs_open(struct outputs *o, struct run *r, const char *folder, long resume_step) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->open) kind[k]->open(o->self[k], r, folder, resume_step);
}

void outputs_prepare(struct outputs *o, struct run *r) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->prepare) kind[k]->prepare(o->self[k], r);
}

static int is_due(const struct output *a, const void *self, const struct outputs_moment *m) {
    return a->due ? a->due(self, m) : m->series_due;
}

void outputs_sample(struct outputs *o, struct run *r, int series_due, int fields_due, int stage_ends) {
    const struct outputs_moment m = {r->step, series_due, fields_due, stage_ends, &o->found};
    clock_begin(CLOCK_SERIES);
    for (int k = 0; k < KINDS; k++) {
        if (!o->self[k]) continue;
        if (is_due(kind[k], o->self[k], &m))
            kind[k]->sample(o->self[k], r, &m);
        else if (kind[k]->cancel)
            kind[k]->cancel(o->self[k], r);
    }
    clock_end(CLOCK_SERIES);
}

enum signals_reason outputs_stopped(const struct outputs *o) { return o->found.stopped; }

void outputs_flush(struct outputs *o, struct run *r) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->flush) kind[k]->flush(o->self[k], r);
}

void outputs_report(const struct outputs *o, const struct run *r) {
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->report) kind[k]->report(o->self[k], r);
}

double outputs_numbers(const struct outputs *o, const struct run *r, long steps) {
    double sum = 0;
    for (int k = 0; k < KINDS; k++)
        if (o->self[k] && kind[k]->numbers) sum += kind[k]->numbers(o->self[k], r, steps);
    return sum;
}

const struct series_sample *outputs_last(const struct outputs *o) { return &o->found.series; }

void outputs_free(struct outputs *o) {
    if (!o) return;
    for (int k = 0; k < KINDS; k++)
        if (o->self[k]) kind[k]->free(o->self[k]);
    free(o);
}
