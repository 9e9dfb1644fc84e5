/* Section of the report on events of fracture: how many, the largest, their places and sums over time. */
#include "base/files/folder.h"
#include "base/arena.h"
#include "postproc/charts/events.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Columns of events.csv, [rows]; rows 0 without them. */
struct list {
    long rows;
    int dim;
    double *t, *bonds, *area, *energy, *x[3], *when;
};

static struct list list_new(const struct postproc_history *h) {
    const struct table_data *d = h->events;
    struct list l = {.rows = d ? d->rows : 0};
    l.t = postproc_history_values(d, "t");
    l.when = postproc_history_values(d, "t");
    l.bonds = postproc_history_values(d, "bonds");
    l.area = postproc_history_values(d, "area");
    l.energy = postproc_history_values(d, "energy");
    for (; l.dim < 3; l.dim++)
        if (!(l.x[l.dim] = postproc_history_values(d, (char[]){"xyz"[l.dim], '\0'}))) break;
    if (!l.t || !l.bonds || !l.area || !l.energy || l.dim < 2) l.rows = 0;
    for (long i = 0; i < l.rows; i++) l.when[i] = postproc_history_when(h, l.t[i]);
    return l;
}

/* The sum of a column up to each row, over time, as a chart; of: NULL: the rows are counted. */
static void chart(struct postproc_output *out, const struct postproc_history *h, const struct list *l,
                  const double *weight, const char *name, const char *title, const char *ylabel) {
    char folder[FOLDER_PATH];
    double *sum = arena_new((size_t)l->rows, sizeof *sum), all = 0;
    for (long i = 0; i < l->rows; i++) sum[i] = all += weight ? weight[i] : 1;
    const struct postproc_curve curve = {.title = name, .n = l->rows, .x = l->when, .y = sum};
    if (l->rows >= 2)
        postproc_charts_add(&out->charts, &(struct postproc_plot){.folder = folder_path(folder, out->folder, "plots"),
                                                                  .name = name,
                                                                  .title = title,
                                                                  .xlabel = postproc_history_when_name(h),
                                                                  .ylabel = ylabel,
                                                                  .curves = 1,
                                                                  .curve = &curve});
}

/* The variance of a coordinate over the events, weighted with their energy, m2. */
static double spread(const struct list *l, int c) {
    double all = 0, mean = 0, square = 0;
    for (long i = 0; i < l->rows; i++) {
        all += l->energy[i];
        mean += l->energy[i] * l->x[c][i];
    }
    for (long i = 0; i < l->rows; i++) square += l->energy[i] * pow(l->x[c][i] - mean / all, 2);
    return square / all;
}

/* Seen along the axis in which the events lie closest together. */
static void map(struct postproc_output *out, const struct postproc_history *h, const struct list *l) {
    char folder[FOLDER_PATH];
    int flat = 2;
    for (int c = 0; c < 2 && l->dim == 3; c++)
        if (spread(l, c) < spread(l, flat) * (1 - 1e-9)) flat = c;
    const int across[2] = {flat == 0 ? 1 : 0, flat == 2 ? 1 : 2};
    struct postproc_charts *charts = &out->charts;
    static const char title[] = "Events of fracture: time, and energy by size";
    if (charts->n == POSTPROC_CHARTS) return;
    const enum postproc_plot_status status =
        postproc_events_draw(&(struct postproc_events_plot){.folder = folder_path(folder, out->folder, "plots"),
                                                            .name = "events",
                                                            .title = title,
                                                            .time = postproc_history_when_name(h),
                                                            .across = {"xyz"[across[0]], "xyz"[across[1]]},
                                                            .at = {l->x[across[0]], l->x[across[1]]},
                                                            .when = l->when,
                                                            .energy = l->energy,
                                                            .n = l->rows});
    postproc_charts_note(charts, status, "events", title);
}

void postproc_sections_events(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    struct list l = list_new(h);
    if (l.rows > 0) {
        double bonds = 0, area = 0, energy = 0;
        long most = 0;
        for (long i = 0; i < l.rows; i++) {
            bonds += l.bonds[i];
            area += l.area[i];
            energy += l.energy[i];
            if (l.energy[i] > l.energy[most]) most = i;
        }
        postproc_facts_number(f, "events of fracture", "1", (double)l.rows);
        postproc_facts_number(f, "first event, t", "s", l.t[0]);
        postproc_facts_number(f, "bonds broken in events", "1", bonds);
        postproc_facts_number(f, "energy released by events", "J", energy);
        postproc_facts_number(f, "area of the events' cracks", "m2", area);
        postproc_facts_number(f, "largest event, energy", "J", l.energy[most]);
        postproc_facts_number(f, "largest event, t", "s", l.t[most]);
        for (int c = 0; c < l.dim; c++)
            postproc_facts_number(f, NAMED("largest event, %c", "xyz"[c]), "m", l.x[c][most]);
        map(out, h, &l);
        chart(out, h, &l, NULL, "events_count", "Events of fracture", "events");
        chart(out, h, &l, l.energy, "events_energy", "Energy released by events of fracture", "energy  [J]");
    }
}
