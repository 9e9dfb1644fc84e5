/* Section of the report on detached fragments: times, masses, and the largest one. */
#include "base/files/folder.h"
#include "base/arena.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdlib.h>

/* Columns of fragments.csv, [rows]; rows 0 without them. */
struct pieces {
    long rows;
    double *t, *number, *detached, *mass, *speed, *extent;
};

static struct pieces pieces_new(const struct table_data *d) {
    struct pieces p = {.rows = d ? d->rows : 0};
    p.t = postproc_history_values(d, "t");
    p.number = postproc_history_values(d, "fragment");
    p.detached = postproc_history_values(d, "detached");
    p.mass = postproc_history_values(d, "mass");
    p.speed = postproc_history_values(d, "speed");
    p.extent = postproc_history_values(d, "extent");
    if (!p.t || !p.number || !p.detached || !p.mass || !p.speed || !p.extent) p.rows = 0;
    return p;
}

/* A fragment exists since before the first row, or was detached at the time of a later one. */
static int is_off(const struct pieces *p, long i) { return p->detached[i] > p->t[0]; }

/* The first row of the last list of all pieces: lists are in the order of the numbers and begin with number 0, which
 * always exists; rows of new pieces alone do not have it. */
static long last_list(const struct pieces *p, long *end) {
    long first = p->rows - 1;
    while (first > 0 && p->number[first] != 0) first--;
    for (*end = first + 1; *end < p->rows && p->t[*end] == p->t[first];) ++*end;
    return first;
}

/* The mass of all detached fragments over time, from the complete lists. */
static void chart(struct postproc_output *out, const struct postproc_history *h, const struct pieces *p) {
    char folder[FOLDER_PATH];
    long n = 0;
    double *x = arena_new((size_t)p->rows, sizeof *x), *y = arena_new((size_t)p->rows, sizeof *y);
    for (long i = 0; i < p->rows;) {
        long end = i + 1;
        while (end < p->rows && p->t[end] == p->t[i]) end++;
        double off = 0;
        for (long k = i; k < end; k++) off += is_off(p, k) ? p->mass[k] : 0;
        if (p->number[i] == 0) {
            x[n] = postproc_history_when(h, p->t[i]);
            y[n++] = off;
        }
        i = end;
    }
    const struct postproc_curve curve = {.title = "mass", .n = n, .x = x, .y = y};
    if (n >= 2 && y[n - 1] > 0)
        postproc_charts_add(&out->charts, &(struct postproc_plot){.folder = folder_path(folder, out->folder, "plots"),
                                                                  .name = "detached_mass",
                                                                  .title = "Mass of the pieces that have come off",
                                                                  .xlabel = postproc_history_when_name(h),
                                                                  .ylabel = "mass  [kg]",
                                                                  .curves = 1,
                                                                  .curve = &curve});
}

void postproc_sections_fragments(struct postproc_output *out, const struct postproc_history *h) {
    struct postproc_facts *f = &out->facts;
    struct pieces p = pieces_new(h->fragments);
    if (p.rows > 0) {
        long end, pieces = 0, largest = -1;
        double all = 0, off = 0, momentum = 0, first = INFINITY;
        for (long i = 0; i < p.rows; i++)
            if (is_off(&p, i)) first = fmin(first, p.detached[i]);
        for (long i = last_list(&p, &end); i < end; i++) {
            all += p.mass[i];
            if (!is_off(&p, i)) continue;
            pieces++;
            off += p.mass[i];
            momentum += p.mass[i] * p.speed[i];
            if (largest < 0 || p.mass[i] > p.mass[largest]) largest = i;
        }
        postproc_facts_number(f, "pieces that came off", "1", (double)pieces);
        if (isfinite(first)) postproc_facts_number(f, "first piece came off, t", "s", first);
        postproc_facts_number(f, "mass of the solid", "kg", all);
        if (pieces > 0) {
            postproc_facts_number(f, "mass of the pieces that came off", "kg", off);
            postproc_facts_number(f, "mass of the pieces that came off, share", "1", off / all);
            postproc_facts_number(f, "their mean speed, by mass", "m/s", momentum / off);
            postproc_facts_number(f, "largest piece that came off, mass", "kg", p.mass[largest]);
            postproc_facts_number(f, "largest piece that came off, extent", "m", p.extent[largest]);
            postproc_facts_number(f, "largest piece that came off, speed", "m/s", p.speed[largest]);
            postproc_facts_number(f, "largest piece that came off, t", "s", p.detached[largest]);
        }
        chart(out, h, &p);
    }
}
