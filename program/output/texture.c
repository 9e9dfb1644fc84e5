/* Writes slices.csv and rev.csv. */
#include "coupling/interface/deposit.h"
#include "program/output/outputs.h"
#include "base/memory.h"
#include "base/files/table_columns.h"
#include "coupling/medium/texture.h"

#define SPREAD(name, unit)                                                                                             \
    name "_mean " unit "|" name "_deviation " unit "|" name "_least " unit "|" name "_largest " unit
static const char of_rev[] = "step 1|t s|edge m|parts_x 1|parts_y 1|parts_z 1|" SPREAD("porosity", "1") "|" SPREAD(
    "specific_surface", "1/m") "|" SPREAD("carman", "m2");
#undef SPREAD
enum { SLICE_COLUMNS = 6, REV_COLUMNS = 18 };

struct texture {
    struct outputs_base base; /* its table: slices.csv */
    struct table *rev;
};

static int begin(void *self, struct run *r) {
    (void)self;
    return r->medium && r->scene->output.series_every != 0;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    (void)r;
    ((struct texture *)self)->rev = table_columns_new(folder, "rev.csv", of_rev, 3, resume_step);
}

static void sample_slices(struct texture *t, const struct run *r) {
    for (int c = 0; c < 3; c++) {
        const int n = medium_texture_slices(r->medium, c);
        double *at = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *at);
        double *porosity = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *porosity);
        medium_texture_slice(r->medium, c, at, porosity);
        for (int q = 0; q < n; q++) outputs_row(&t->base, r, (double[SLICE_COLUMNS]){0, 0, c, q, at[q], porosity[q]});
        MEMORY_FREE(porosity, at);
    }
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

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    deposit_update(r);
    sample_slices(self, r);
    sample_rev(self, r);
}

static void free_texture(void *self) { table_free(((struct texture *)self)->rev); }

const struct output output_texture = {
    .file = {"slices.csv", "rev.csv"},
    .columns = "step 1|t s|direction 1|slice 1|at m|porosity 1",
    .bytes = sizeof(struct texture),
    .when = OUTPUTS_STAGE,
    .begin = begin,
    .open = open,
    .sample = sample,
    .free = free_texture,
};
