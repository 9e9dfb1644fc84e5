/* Writes probes.csv: displacement, velocity and damage of single particles during the run. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/energy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEP, T, PROBE, PLACE, COLUMNS_MAX = PLACE + 3 * 3 + 1 };

/* The nearest particle on a rank. */
struct candidate {
    double distance, x[3]; /* spacings, to 1e-6; m */
};

struct probes {
    const struct scene_probes *scene; /* borrowed */
    int dim;
    long particles;          /* number of particles at the last search */
    int *here;               /* [places] this rank's index of the particle, -1: on another rank */
    struct candidate *found; /* [places] */
    struct table *table;
    double *row; /* [places][columns], work */
};

static int columns_of(const struct probes *p) { return PLACE + 3 * p->dim + 1; }

/* Order of candidates: the nearest first; of equally near ones the first in x, then in y, then in z. */
static int is_before(const struct candidate *a, const struct candidate *b) {
    if (a->distance != b->distance) return a->distance < b->distance;
    for (int c = 0; c < 3; c++)
        if (a->x[c] != b->x[c]) return a->x[c] < b->x[c];
    return 0;
}

static struct candidate candidate_of(const struct solid *s, int h, const double place[3]) {
    struct candidate a = {0};
    double square = 0;
    for (int c = 0; c < s->dim; c++) {
        a.x[c] = s->x0[c][h];
        square += (a.x[c] - place[c]) * (a.x[c] - place[c]);
    }
    a.distance = rint(sqrt(square) / s->in.spacing * 1e6) * 1e-6;
    return a;
}

/* Finds the particle of all ranks that is initially nearest to each place. Collective. */
static void find(struct probes *p, const struct solid *s) {
    const int places = p->scene->places;
    const size_t bytes = (size_t)places * sizeof *p->found;
    struct candidate *all = memory_new(MEMORY_OUTPUT, (size_t)(places * par_size()), sizeof *all);
    for (int k = 0; k < places; k++) {
        p->found[k] = (struct candidate){.distance = INFINITY};
        p->here[k] = -1;
        for (int h = 0; h < s->n; h++) {
            const struct candidate a = candidate_of(s, h, p->scene->at[k]);
            if (!is_before(&a, &p->found[k])) continue;
            p->found[k] = a;
            p->here[k] = h;
        }
    }
    par_all_gather(p->found, bytes, all);
    for (int q = 0; q < par_size(); q++)
        for (int k = 0; k < places; k++)
            if (is_before(&all[q * places + k], &p->found[k])) {
                p->found[k] = all[q * places + k];
                p->here[k] = -1;
            }
    memory_free(all);
    p->particles = s->n_global;
}

static void *new (struct run *r) {
    const struct scene_probes *scene = r->scene->output.probes;
    if (!scene || !r->needs.bonds) return NULL;
    struct probes *p = calloc(1, sizeof *p);
    ENSURE(p, "no memory for probes");
    p->scene = scene;
    p->dim = r->solid->dim;
    p->here = memory_new(MEMORY_OUTPUT, (size_t)scene->places, sizeof *p->here);
    p->found = memory_new(MEMORY_OUTPUT, (size_t)scene->places, sizeof *p->found);
    p->row = memory_new(MEMORY_OUTPUT, (size_t)(scene->places * columns_of(p)), sizeof *p->row);
    find(p, r->solid);
    for (int k = 0; k < scene->places; k++)
        if (p->found[k].distance > 1)
            die_all(EXIT_CODE_SCENE,
                    "%s: output.probes.at[%d]: the nearest particle is %.3g m away, more than a spacing",
                    r->scene->path, k, p->found[k].distance * r->solid->in.spacing);
    return p;
}

/* Appends a row for each place. */
static void write(struct probes *p, struct run *r) {
    struct solid *s = r->solid;
    const int places = p->scene->places, columns = columns_of(p);
    clock_begin(CLOCK_OUTPUT);
    if (p->particles != s->n_global) find(p, s);
    solid_ghosts_update(s);
    for (int k = 0; k < places; k++) {
        double *row = p->row + k * columns, stretch;
        const int h = p->here[k];
        memset(row, 0, (size_t)columns * sizeof *row);
        if (h < 0) continue;
        row[STEP] = (double)r->step;
        row[T] = r->t;
        row[PROBE] = k;
        for (int c = 0; c < p->dim; c++) {
            row[PLACE + c] = s->x0[c][h];
            row[PLACE + p->dim + c] = s->d[c][h];
            row[PLACE + 2 * p->dim + c] = s->v[c][h];
        }
        solid_energy_bonds_of(s, h, &row[columns - 1], &stretch);
    }
    par_sum_array(p->row, places * columns);
    for (int k = 0; k < places; k++) table_add(p->table, p->row + k * columns);
    table_flush(p->table);
    clock_end(CLOCK_OUTPUT);
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct probes *p = self;
    static const char *const vector[3] = {"", "displacement_", "velocity_"}, *const unit_of[3] = {"m", "m", "m/s"};
    static const char letter[] = "xyz";
    char path[FOLDER_PATH], text[COLUMNS_MAX][32] = {"step", "t", "probe"};
    const char *name[COLUMNS_MAX], *unit[COLUMNS_MAX] = {"1", "s", "1"};
    int n = PLACE;
    for (int v = 0; v < 3; v++)
        for (int c = 0; c < p->dim; c++, n++) {
            strcat(strcpy(text[n], vector[v]), (char[]){letter[c], '\0'});
            unit[n] = unit_of[v];
        }
    strcpy(text[n], "energy_density");
    unit[n++] = "J/m3";
    for (int k = 0; k < n; k++) name[k] = text[k];
    p->table = table_new(folder_path(path, folder, "probes.csv"), n, name, unit, resume_step);
    if (resume_step < 0) write(p, r);
}

static int due(const void *self, const struct outputs_moment *m) {
    return m->step % ((const struct probes *)self)->scene->every == 0;
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    write(self, r);
}

static double numbers(const void *self, const struct run *r, long steps) {
    const struct probes *p = self;
    (void)r;
    return (double)steps / (double)p->scene->every * p->scene->places * columns_of(p);
}

static void free_probes(void *self) {
    struct probes *p = self;
    table_free(p->table);
    memory_free(p->here);
    memory_free(p->found);
    memory_free(p->row);
    free(p);
}

const struct output output_probes = {.file = {"probes.csv"},
                                     .new = new,
                                     .open = open,
                                     .due = due,
                                     .sample = sample,
                                     .free = free_probes,
                                     .numbers = numbers};
