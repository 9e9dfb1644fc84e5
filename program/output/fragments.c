/* Writes fragments.csv: pieces of the solid with number, time of detachment, mass, place, velocity and size. */
#include "program/output/outputs.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/measure/detachment.h"
#include "solid/refine/refine.h"

#include <math.h>
#include <stdlib.h>

/* clang-format off */
enum { STEP, T, FRAGMENT, DETACHED, FROM, ID, PARTICLES, HELD, MASS, VOLUME, EXTENT, SPEED, PLACE,
       COLUMNS_MAX = PLACE + 6 };
/* clang-format on */

struct fragments {
    struct outputs_base base;
    long bonds_broken, refinements; /* at the last search for pieces, -1: none yet */
    double pieces, largest;         /* what it found: number of pieces, particles of the largest */
    long *id;                       /* [capacity], work */
    int capacity;
};

static int begin(void *self, struct run *r) {
    struct fragments *f = self;
    if (!r->needs.breakage || !r->scene->output.fragments || r->scene->output.series_every == 0) return 0;
    f->bonds_broken = -1;
    f->pieces = f->largest = -1;
    solid_detachment_begin(r->solid);
    return 1;
}

/* The fragments to write, in the order of their numbers. */
struct chosen {
    long number;
    int at; /* in the list */
};

static int by_number(const void *a, const void *b) {
    const struct chosen *p = a, *q = b;
    return (p->number > q->number) - (p->number < q->number);
}

static void write_rows(struct fragments *f, const struct run *r, int n, const int *which,
                       const struct solid_fragment *list, const struct solid_detachment *detachment) {
    struct solid_detachment_size *size = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *size);
    solid_detachment_sizes(r->solid, f->id, list, n, which, size);
    for (int k = 0; k < n; k++) {
        const struct solid_fragment *is = &list[which[k]];
        const struct solid_detachment *off = &detachment[which[k]];
        double row[COLUMNS_MAX] = {[FRAGMENT] = (double)off->number,
                                   [DETACHED] = off->since,
                                   [FROM] = off->is_new && off->from >= 0 ? (double)off->from : NAN,
                                   [ID] = (double)is->id,
                                   [PARTICLES] = (double)is->particles,
                                   [HELD] = is->held,
                                   [MASS] = is->mass,
                                   [VOLUME] = size[k].volume,
                                   [EXTENT] = size[k].extent,
                                   [SPEED] = sqrt(is->v[0] * is->v[0] + is->v[1] * is->v[1] + is->v[2] * is->v[2])};
        for (int c = 0; c < r->solid->dim; c++) {
            row[PLACE + c] = size[k].centre[c];
            row[PLACE + r->solid->dim + c] = is->v[c];
        }
        outputs_row(&f->base, r, row);
    }
    memory_free(size);
}

/* Appends a row for each piece that has come off since the last call; all: for every piece. */
static void write(struct fragments *f, struct run *r, int all) {
    struct solid *s = r->solid;
    solid_family_count(s);
    const int same = s->bonds_broken == f->bonds_broken && solid_refine_events(s) == f->refinements;
    f->bonds_broken = s->bonds_broken;
    f->refinements = solid_refine_events(s);
    if (!same || all) {
        if (s->n >= f->capacity) {
            f->capacity = s->n + s->n / 4 + 1;
            f->id = memory_renew(MEMORY_OUTPUT, f->id, (size_t)f->capacity, sizeof *f->id);
        }
        struct solid_fragment *list;
        struct solid_detachment *detachment;
        const int n = solid_detachment_update(s, r->t, f->id, &list, &detachment);
        f->pieces = n;
        f->largest = n > 0 ? (double)list[0].particles : 0;
        struct chosen *chosen = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *chosen);
        int *which = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *which), m = 0;
        for (int i = 0; i < n; i++)
            if (all || detachment[i].is_new) chosen[m++] = (struct chosen){detachment[i].number, i};
        qsort(chosen, (size_t)m, sizeof *chosen, by_number);
        for (int k = 0; k < m; k++) which[k] = chosen[k].at;
        write_rows(f, r, m, which, list, detachment);
        MEMORY_FREE(which, chosen);
        free(list);
        free(detachment);
    }
}

/* All pieces are listed at the beginning, with each dump of the fields and at a stage's end. */
static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct fragments *f = self;
    write(f, r, m->fields_due || m->stage_ends || m->first);
    m->found->fragments = f->pieces;
    m->found->largest_fragment = f->largest;
}

static void free_fragments(void *self) { memory_free(((struct fragments *)self)->id); }

const struct output output_fragments = {
    .file = {"fragments.csv"},
    .columns = "step 1|t s|fragment 1|detached s|from 1|id 1|particles 1|held 1|mass kg|volume m3|extent m|speed m/s|* "
               "m|velocity_* m/s",
    .bytes = sizeof(struct fragments),
    .when = OUTPUTS_SERIES | OUTPUTS_FIELDS,
    .begin = begin,
    .first = 1,
    .sample = sample,
    .free = free_fragments,
};
