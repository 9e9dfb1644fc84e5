/* Section of the report with planes of the fluid: speed, pressure and vorticity. */
#include "base/files/folder.h"
#include "postproc/charts/slice.h"
#include "postproc/draw/legend.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>

enum { SPEED, PRESSURE, VORTICITY, KINDS };
static const struct {
    const char *name, *title, *label;
} kinds[KINDS] = {{"speed", "Speed |u|", "|u|  [m/s]"},
                  {"pressure", "Pressure p", "p  [Pa]"},
                  {"vorticity", "Vorticity |ω|", "|ω|  [1/s]"}};
enum { CELLS_MIN = 4, SQUARES = 30 }; /* a plane of fewer cells across is not drawn */

static const double *values_of(const struct postproc_slice *s, int kind) {
    return kind == SPEED ? s->speed : kind == PRESSURE ? s->pressure : s->vorticity;
}

/* Common colours of the planes: pressure from the 1 % to the 99 % quantile; speed and vorticity from 0, speed
 * up to the 99.9 % one. Returns 0 if the values are
 * all equal. */
static int limits_of(struct postproc_slice *const slice[3], int kind, double limit[2]) {
    limit[0] = INFINITY;
    limit[1] = -INFINITY;
    for (int a = 0; a < 3; a++) {
        const double *value = slice[a] ? values_of(slice[a], kind) : NULL;
        if (!value) continue;
        limit[0] = fmin(limit[0], postproc_slice_quantile(slice[a], value, 0.01));
        limit[1] = fmax(limit[1], postproc_slice_quantile(slice[a], value, kind == SPEED ? 0.999 : 0.99));
    }
    if (kind != PRESSURE) limit[0] = 0;
    return limit[1] > limit[0] + 1e-9 * fabs(limit[1]);
}

static void slice_draw(struct postproc_output *out, const struct postproc_history *h, const struct postproc_slice *s,
                       int kind, double limit[2]) {
    static const char *const axis[3] = {"x", "y", "z"};
    char folder[FOLDER_PATH], name[64], title[96], where[160], caption[160], when[64], place[32];
    struct postproc_stream lines = {0};
    if (kind == SPEED) lines = postproc_slice_lines(s, SQUARES);
    snprintf(name, sizeof name, "slice_%s_%s", axis[s->axis], kinds[kind].name);
    postproc_sections_when(h, s->time, when);
    postproc_legend_length(s->place, place);
    snprintf(title, sizeof title, "%s%s", kinds[kind].title,
             lines.lines ? ", lines along the velocity in the plane" : "");
    snprintf(where, sizeof where, "%s = %s, %s, step %ld", axis[s->axis], place, when, s->step);
    snprintf(caption, sizeof caption, "%s, at %s = %s", title, axis[s->axis], place);
    const enum postproc_plot_status status =
        postproc_slice_draw(&(struct postproc_slice_plot){.folder = folder_path(folder, out->folder, "pictures"),
                                                          .name = name,
                                                          .all = 1,
                                                          .title = title,
                                                          .subtitle = where,
                                                          .label = kinds[kind].label,
                                                          .slice = s,
                                                          .value = values_of(s, kind),
                                                          .lines = kind == SPEED ? &lines : NULL,
                                                          .low = limit[0],
                                                          .high = limit[1],
                                                          .map = postproc_sections_map(limit)});
    postproc_stream_free(&lines);
    if (status != POSTPROC_PLOT_DONE)
        out->charts.worst = status;
    else
        postproc_sections_picture(out, name, caption);
}

void postproc_sections_flow(struct postproc_output *out, const struct postproc_history *h) {
    if (h->fluid.n == 0) return;
    struct postproc_slice *slice[3] = {NULL, NULL, NULL};
    for (int a = 0; a < 3; a++) {
        slice[a] = postproc_slice_new(h, h->fluid.n - 1, a, out->options.sliced[a] ? out->options.slice[a] : NAN);
        if (!slice[a] || (slice[a]->n[0] >= CELLS_MIN && slice[a]->n[1] >= CELLS_MIN)) continue;
        postproc_slice_free(slice[a]);
        slice[a] = NULL;
    }
    for (int kind = 0; kind < KINDS; kind++) {
        double limit[2];
        if (!limits_of(slice, kind, limit)) continue; /* nothing flows, or nothing presses */
        for (int a = 2; a >= 0; a--)
            if (slice[a] && values_of(slice[a], kind)) slice_draw(out, h, slice[a], kind, limit);
    }
    for (int a = 0; a < 3; a++) postproc_slice_free(slice[a]);
}
