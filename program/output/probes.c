/* Writes probes.csv: displacement, velocity and damage of single particles during the run. */
#include "program/output/outputs.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/energy.h"

#include <math.h>
#include <string.h>

enum { STEP, T, PROBE, PLACE };

/* The nearest particle on a rank. */
struct candidate {
    double distance, x[3]; /* spacings, to 1e-6; m */
};

struct probes {
    struct outputs_base base;
    const struct scene_probes *scene; /* borrowed */
    long particles;                   /* number of particles at the last search */
    int *here;                        /* [places] this rank's index of the particle, -1: on another rank */
    struct candidate *found;          /* [places] */
    double *row;                      /* [places][columns], work */
};

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

static int begin(void *self, struct run *r) {
    const struct scene_probes *scene = r->scene->output.probes;
    struct probes *p = self;
    if (!scene || !r->needs.bonds) return 0;
    p->base.every = scene->every;
    p->base.rows = scene->places;
    p->scene = scene;
    p->here = memory_new(MEMORY_OUTPUT, (size_t)scene->places, sizeof *p->here);
    p->found = memory_new(MEMORY_OUTPUT, (size_t)scene->places, sizeof *p->found);
    p->row = memory_new(MEMORY_OUTPUT, (size_t)(scene->places * p->base.columns), sizeof *p->row);
    find(p, r->solid);
    for (int k = 0; k < scene->places; k++)
        if (p->found[k].distance > 1)
            die_all(EXIT_CODE_SCENE,
                    "%s: output.probes.at[%d]: the nearest particle is %.3g m away, more than a spacing",
                    r->scene->path, k, p->found[k].distance * r->solid->in.spacing);
    return 1;
}

/* Appends a row for each place. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct probes *p = self;
    struct solid *s = r->solid;
    const int places = p->scene->places, columns = p->base.columns;
    (void)m;
    if (p->particles != s->n_global) find(p, s);
    solid_ghosts_update(s);
    for (int k = 0; k < places; k++) {
        double *row = p->row + k * columns, stretch;
        const int h = p->here[k];
        memset(row, 0, (size_t)columns * sizeof *row);
        if (h < 0) continue;
        row[PROBE] = k;
        for (int c = 0; c < s->dim; c++) {
            row[PLACE + c] = s->x0[c][h];
            row[PLACE + s->dim + c] = s->d[c][h];
            row[PLACE + 2 * s->dim + c] = s->v[c][h];
        }
        solid_energy_bonds_of(s, h, &row[columns - 1], &stretch);
    }
    par_sum_array(p->row, places * columns);
    for (int k = 0; k < places; k++) outputs_row(&p->base, r, p->row + k * columns);
}

static void free_probes(void *self) {
    struct probes *p = self;
    MEMORY_FREE(p->here, p->found, p->row);
}

const struct output output_probes = {
    .file = {"probes.csv"},
    .columns = "step 1|t s|probe 1|* m|displacement_* m|velocity_* m/s|energy_density J/m3",
    .bytes = sizeof(struct probes),
    .when = OUTPUTS_EVERY,
    .begin = begin,
    .first = 1,
    .sample = sample,
    .free = free_probes,
};
