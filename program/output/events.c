/* Writes events.csv: number, place, normal, area and energy of the clusters of bonds that broke in a step. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "solid/measure/events.h"

#include <stdlib.h>
#include <string.h>

enum { STEP, T, EVENT, BONDS, PLACE, COLUMNS_MAX = PLACE + 9 };

struct events {
    struct table *table;
    int dim;
    long number; /* of the next event, on rank 0 */
};

static void *new (struct run *r) {
    if (!r->solid || !r->solid->breaks) return NULL;
    struct events *e = calloc(1, sizeof *e);
    ENSURE(e, "no memory for events");
    e->dim = r->solid->dim;
    return e;
}

/* The events that a file has, on rank 0. */
static long written(const char *path) {
    struct table_data *d = par_rank() == 0 ? table_read(path, NULL) : NULL;
    const long rows = d ? d->rows : 0;
    table_read_free(d);
    return rows;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct events *e = self;
    static const char letter[] = "xyz";
    char path[FOLDER_PATH], text[6][16];
    const char *name[COLUMNS_MAX] = {"step", "t", "event", "bonds"};
    const char *unit[COLUMNS_MAX] = {"1", "s", "1", "1"};
    int n = PLACE;
    (void)r;
    for (int c = 0; c < 2 * e->dim; c++, n++) {
        strcat(strcpy(text[c], c < e->dim ? "" : "normal_"), (char[]){letter[c % e->dim], '\0'});
        name[n] = text[c];
        unit[n] = c < e->dim ? "m" : "1";
    }
    name[n] = "alignment";
    unit[n++] = "1";
    name[n] = "area";
    unit[n++] = "m2";
    name[n] = "energy";
    unit[n++] = "J";
    e->table = table_new(folder_path(path, folder, "events.csv"), n, name, unit, resume_step);
    e->number = resume_step < 0 ? 0 : written(path);
}

static void add_row(struct events *e, const struct solid_event *event) {
    double row[COLUMNS_MAX] = {
        [STEP] = (double)event->step, [T] = event->t, [EVENT] = (double)e->number++, [BONDS] = (double)event->bonds};
    int n = PLACE;
    for (int c = 0; c < e->dim; c++) row[n++] = event->centre[c];
    for (int c = 0; c < e->dim; c++) row[n++] = event->normal[c];
    row[n++] = event->alignment;
    row[n++] = event->area;
    row[n++] = event->energy;
    table_add(e->table, row);
}

/* Appends the events of the bonds that have broken since the last call. */
static void write(void *self, struct run *r) {
    struct events *e = self;
    clock_begin(CLOCK_OUTPUT);
    struct solid_break *bond;
    const struct solid_input *in = &r->solid->in;
    const long n = solid_events_take(r->solid, &bond);
    if (par_rank() == 0 && n > 0) {
        struct solid_event *event;
        const long events = solid_events_of(bond, n, solid_events_reach(in), in->periodic, in->length, &event);
        for (long k = 0; k < events; k++) add_row(e, &event[k]);
        table_flush(e->table);
        free(event);
    }
    free(bond);
    clock_end(CLOCK_OUTPUT);
}

static int due(const void *self, const struct outputs_moment *m) {
    (void)self;
    return m->series_due || m->fields_due || m->stage_ends;
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    (void)m;
    write(self, r);
}

static void free_events(void *self) {
    struct events *e = self;
    table_free(e->table);
    free(e);
}

/* Written before each checkpoint too: the state has no list of the bonds that broke. */
const struct output output_events = {.file = {"events.csv"},
                                     .new = new,
                                     .open = open,
                                     .due = due,
                                     .sample = sample,
                                     .free = free_events,
                                     .flush = write};
