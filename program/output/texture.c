/* Writes slices.csv and rev.csv. */
#include "coupling/interface/deposit.h"
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "coupling/medium/texture.h"
#include "base/files/folder.h"
#include "base/files/table.h"

#include <math.h>
#include <stdlib.h>

static const char *const slice_name[] = {"step", "t", "direction", "slice", "at", "porosity"};
static const char *const slice_unit[] = {"1", "s", "1", "1", "m", "1"};
enum { SLICE_COLUMNS = sizeof slice_name / sizeof *slice_name };

#define SPREAD(name) name "_mean", name "_deviation", name "_least", name "_largest"
static const char *const rev_name[] = {
    "step",          "t", "edge", "parts_x", "parts_y", "parts_z", SPREAD("porosity"), SPREAD("specific_surface"),
    SPREAD("carman")};
static const char *const rev_unit[] = {"1", "s",   "m",   "1",   "1",   "1",  "1",  "1",  "1",
                                       "1", "1/m", "1/m", "1/m", "1/m", "m2", "m2", "m2", "m2"};
#undef SPREAD
enum { REV_COLUMNS = sizeof rev_name / sizeof *rev_name };
_Static_assert((int)REV_COLUMNS == (int)(sizeof rev_unit / sizeof *rev_unit), "a unit a column");

struct texture {
    struct table *slices, *rev;
};

static void *new (struct run *r) {
    if (!r->medium || r->scene->output.series_every == 0) return NULL;
    struct texture *t = calloc(1, sizeof *t);
    ENSURE(t, "no memory for the texture");
    return t;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct texture *t = self;
    char path[FOLDER_PATH];
    (void)r;
    t->slices = table_new(folder_path(path, folder, "slices.csv"), SLICE_COLUMNS, slice_name, slice_unit, resume_step);
    t->rev = table_new(folder_path(path, folder, "rev.csv"), REV_COLUMNS, rev_name, rev_unit, resume_step);
}

static void sample_slices(struct texture *t, const struct run *r) {
    for (int c = 0; c < 3; c++) {
        const int n = medium_texture_slices(r->medium, c);
        double *at = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *at);
        double *porosity = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *porosity);
        medium_texture_slice(r->medium, c, at, porosity);
        for (int q = 0; q < n; q++)
            table_add(t->slices, (const double[SLICE_COLUMNS]){(double)r->step, r->t, c, q, at[q], porosity[q]});
        memory_free(porosity);
        memory_free(at);
    }
    table_flush(t->slices);
}

/* The wetted surface is that of the particles now on the interface, at their places. */
static void sample_rev(struct texture *t, const struct run *r) {
    const struct solid_surface *s = r->surface;
    struct medium_texture_size size[MEDIUM_TEXTURE_SIZES];
    double *x[3], *area = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *area);
    for (int c = 0; c < 3; c++) {
        x[c] = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof **x);
        for (int k = 0; k < s->n; k++) x[c][k] = r->solid->x0[c][s->h[k]] + r->solid->d[c][s->h[k]];
    }
    for (int k = 0; k < s->n; k++) area[k] = s->area[k] * (s->two_sided[k] == SOLID_TWO_FACES ? 2 : 1);
    const int n = medium_texture_sizes(r->medium, s->n, (const double *const *)x, area, size);
    for (int q = 0; q < n; q++) {
        double row[REV_COLUMNS] = {(double)r->step, r->t, size[q].edge, size[q].parts[0], size[q].parts[1],
                                   size[q].parts[2]};
        for (int k = 0; k < 4; k++) {
            row[6 + k] = size[q].porosity[k];
            row[10 + k] = size[q].specific_surface[k];
            row[14 + k] = size[q].carman[k];
        }
        table_row(t->rev, row);
    }
    for (int c = 0; c < 3; c++) memory_free(x[c]);
    memory_free(area);
}

static int due(const void *self, const struct outputs_moment *m) {
    (void)self;
    return m->stage_ends;
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    clock_begin(CLOCK_OUTPUT);
    deposit_update(r);
    sample_slices(self, r);
    sample_rev(self, r);
    clock_end(CLOCK_OUTPUT);
}

static void free_texture(void *self) {
    struct texture *t = self;
    table_free(t->slices);
    table_free(t->rev);
    free(t);
}

const struct output output_texture = {
    .file = {"slices.csv", "rev.csv"}, .new = new, .open = open, .due = due, .sample = sample, .free = free_texture};
