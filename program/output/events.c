/* Writes events.csv: number, place, normal, area and energy of the clusters of bonds that broke in a step. */
#include "program/output/outputs.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "solid/measure/events.h"

#include <stdlib.h>

enum { STEP, T, EVENT, BONDS, PLACE, COLUMNS_MAX = PLACE + 9 };

struct events {
    struct outputs_base base;
    long number; /* of the next event, on rank 0 */
};

static int begin(void *self, struct run *r) {
    (void)self;
    return r->solid && r->solid->breaks;
}

/* The events that a file has, on rank 0. */
static long written(const char *path) {
    struct table_data *d = par_rank() == 0 ? table_read(path, NULL) : NULL;
    const long rows = d ? d->rows : 0;
    table_read_free(d);
    return rows;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    char path[FOLDER_PATH];
    (void)r;
    if (resume_step >= 0) ((struct events *)self)->number = written(folder_path(path, folder, "events.csv"));
}

static void add_row(struct events *e, int dim, const struct solid_event *event) {
    double row[COLUMNS_MAX] = {
        [STEP] = (double)event->step, [T] = event->t, [EVENT] = (double)e->number++, [BONDS] = (double)event->bonds};
    int n = PLACE;
    for (int c = 0; c < dim; c++) row[n++] = event->centre[c];
    for (int c = 0; c < dim; c++) row[n++] = event->normal[c];
    row[n++] = event->alignment;
    row[n++] = event->area;
    row[n++] = event->energy;
    table_add(e->base.table, row);
}

/* Appends the events of the bonds that have broken since the last call. */
static void write(void *self, struct run *r) {
    struct events *e = self;
    struct solid_break *bond;
    const struct solid_input *in = &r->solid->in;
    const long n = solid_events_take(r->solid, &bond);
    if (par_rank() == 0 && n > 0) {
        struct solid_event *event;
        const long events = solid_events_of(bond, n, solid_events_reach(in), in->periodic, in->length, &event);
        for (long k = 0; k < events; k++) add_row(e, r->solid->dim, &event[k]);
        free(event);
    }
    free(bond);
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    write(self, r);
}

/* Written before each checkpoint too: the state has no list of the bonds that broke. */
const struct output output_events = {
    .file = {"events.csv"},
    .columns = "step 1|t s|event 1|bonds 1|* m|normal_* 1|alignment 1|area m2|energy J",
    .bytes = sizeof(struct events),
    .when = OUTPUTS_SERIES | OUTPUTS_FIELDS | OUTPUTS_STAGE,
    .begin = begin,
    .open = open,
    .sample = sample,
    .flush = write,
};
