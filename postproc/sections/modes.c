/* Section of the report on the azimuthal modes of the damage: mean and largest mode of each ring at the last sample,
 * and a plot of the amplitudes. */
#include "base/files/folder.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

enum { RINGS_MAX = 12, NAME = 96 };

/* Columns of modes.csv, [rows]; rows 0 without them. */
struct rows {
    long rows;
    double *t, *ring, *inner, *outer, *mode, *amplitude, *angle;
};

static struct rows rows_new(const struct table_data *d) {
    struct rows r = {.rows = d ? d->rows : 0};
    r.t = postproc_history_values(d, "t");
    r.ring = postproc_history_values(d, "ring");
    r.inner = postproc_history_values(d, "inner");
    r.outer = postproc_history_values(d, "outer");
    r.mode = postproc_history_values(d, "mode");
    r.amplitude = postproc_history_values(d, "amplitude");
    r.angle = postproc_history_values(d, "angle");
    if (!r.t || !r.ring || !r.inner || !r.outer || !r.mode || !r.amplitude || !r.angle) r.rows = 0;
    return r;
}

/* One ring: the row of its mean, which the rows of its modes follow up to `end`. */
static void add_ring(struct postproc_facts *f, const struct rows *r, long first, long end) {
    char ring[NAME];
    long most = first + 1;
    for (long i = first + 1; i < end; i++)
        if (r->amplitude[i] > r->amplitude[most]) most = i;
    snprintf(ring, sizeof ring, "damage from %.4g to %.4g m", r->inner[first], r->outer[first]);
    postproc_facts_number(f, NAMED("%s, mean", ring), "1", r->amplitude[first]);
    if (most >= end || !(r->amplitude[most] > 0)) return;
    postproc_facts_number(f, NAMED("%s, largest mode", ring), "1", r->mode[most]);
    postproc_facts_number(f, NAMED("%s, its amplitude", ring), "1", r->amplitude[most]);
    postproc_facts_number(f, NAMED("%s, its angle", ring), "degrees", r->angle[most]);
}

void postproc_sections_modes(struct postproc_output *out, const struct postproc_history *h) {
    struct rows r = rows_new(h->modes);
    struct postproc_curve curve[RINGS_MAX];
    char folder[FOLDER_PATH], title[RINGS_MAX][NAME];
    int rings = 0;
    long first = r.rows > 0 ? r.rows - 1 : 0;
    while (first > 0 && r.t[first - 1] == r.t[r.rows - 1]) first--; /* of the last sample */
    for (long i = first, end; i < r.rows; i = end) {
        for (end = i + 1; end < r.rows && r.ring[end] == r.ring[i];) end++;
        add_ring(&out->facts, &r, i, end);
        if (rings == RINGS_MAX || !(r.amplitude[i] > 0)) continue;
        const char *unit;
        const double metre = postproc_plot_unit(r.outer[r.rows - 1], &unit);
        snprintf(title[rings], NAME, "%.3g to %.3g %s", r.inner[i] / metre, r.outer[i] / metre, unit);
        curve[rings] = (struct postproc_curve){
            .title = title[rings], .n = end - i - 1, .x = r.mode + i + 1, .y = r.amplitude + i + 1, .points = 1};
        rings++;
    }
    if (rings > 0)
        postproc_charts_add(&out->charts, &(struct postproc_plot){.folder = folder_path(folder, out->folder, "plots"),
                                                                  .name = "modes",
                                                                  .title = "Azimuthal modes of the damage, by ring",
                                                                  .xlabel = "mode",
                                                                  .ylabel = "amplitude",
                                                                  .curves = rings,
                                                                  .curve = curve});
}
