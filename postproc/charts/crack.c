/* Draws curves of crack.csv: the crack's speed, length, path and released energy. */
#include "postproc/charts/charts.h"
#include "base/arena.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LINES = 2, RUNS_MAX = 16, TITLE = 96 };

/* Columns of crack.csv drawn against another one, each divided by a unit. */
static const struct chart {
    const char *name, *title, *ylabel;
    double unit;
    struct {
        const char *column, *title;
    } line[LINES];
    const char *x; /* NULL: time */
    int speed;     /* 1: plotted at the middle of the time window, with the Rayleigh speed */
} all_charts[] = {
    {"crack_speed", "Speed of the crack's tip", "speed  [m/s]", 1, .line = {{"speed", "tip"}}, .speed = 1},
    {"crack_x", "Where the crack's tip is: x", "x  [mm]", 1e-3, .line = {{"tip_x", "tip"}}},
    {"crack_y", "Where the crack's tips are: y", "y  [mm]", 1e-3,
     .line = {{"left_y", "left of the axis"}, {"right_y", "right of the axis"}}},
    {"crack_path", "The way of the crack's tips", "y  [mm]", 1e-3,
     .line = {{"left_y", "left of the axis"}, {"right_y", "right of the axis"}}, .x = "_x"},
    {"crack_length", "Length that the crack has grown by", "length  [mm]", 1e-3, .line = {{"length", "length"}}},
    {"crack_energy", "Energy released over the crack's new area, over G_0", "E / (G_0 A)", 1,
     .line = {{"energy_over_g0", "released by bonds"}}},
};
enum { CHARTS = sizeof all_charts / sizeof *all_charts };

struct drawing {
    struct postproc_curve curve[(LINES + 1) * RUNS_MAX];
    char title[(LINES + 1) * RUNS_MAX][TITLE];
    int curves;
    double time_unit;
};

static struct postproc_curve *curve_add(struct drawing *d, long n, const double *x, const double *y) {
    struct postproc_curve *c = &d->curve[d->curves];
    *c = (struct postproc_curve){.title = d->title[d->curves++], .n = n, .x = x, .y = y};
    return c;
}

static void line_add(struct drawing *d, const struct chart *chart, int l, const struct postproc_history *h,
                     const char *label) {
    char across[32];
    const char *column = chart->line[l].column;
    if (chart->x)
        snprintf(across, sizeof across, "%.*s%s", (int)(chart->line[l].column[0] == 'l' ? 4 : 5), column, "_x");
    double *y = postproc_history_values(h->crack, column);
    double *x = postproc_history_values(h->crack, chart->x ? across : "t");
    const double window = h->scene->output.crack ? h->scene->output.crack->window : 0;
    long finite = 0;
    for (long i = 0; x && y && i < h->crack->rows; i++) {
        const double start = h->crack->value[table_read_column(h->crack, "t")];
        if (chart->speed) x[i] -= 0.5 * fmin(window, x[i] - start);
        x[i] /= chart->x ? chart->unit : d->time_unit;
        y[i] /= chart->unit;
        finite += isfinite(x[i]) && isfinite(y[i]);
    }
    if (finite < 2) return;
    snprintf(d->title[d->curves], TITLE, "%s", label ? label : chart->line[l].title);
    curve_add(d, h->crack->rows, x, y);
}

/* Adds a horizontal line from the first to the last time of a run. */
static void rayleigh_add(struct drawing *d, const struct postproc_history *h) {
    const struct postproc_curve *with = &d->curve[d->curves - 1];
    double *x = arena_new(2, sizeof *x), *y = arena_new(2, sizeof *y);
    y[0] = y[1] = postproc_history_waves(h).rayleigh;
    x[0] = with->x[0];
    x[1] = with->x[with->n - 1];
    snprintf(d->title[d->curves], TITLE, "Rayleigh speed %.0f m/s", y[0]);
    curve_add(d, 2, x, y);
}

static void chart_draw(struct postproc_charts *charts, const struct chart *chart, int runs,
                       struct postproc_history *const *run, const char *const *label, const char *folder) {
    struct drawing *d = arena_new(1, sizeof *d);
    double end = 0;
    for (int r = 0; r < runs; r++)
        if (run[r]->crack) end = fmax(end, run[r]->end);
    d->time_unit = end < 1e-3 ? 1e-6 : end < 1 ? 1e-3 : 1;
    int last = -1;
    for (int r = 0; r < runs && r < RUNS_MAX; r++) {
        const int before = d->curves;
        for (int l = 0; run[r]->crack && l < LINES && chart->line[l].column && (runs == 1 || l == 0); l++)
            line_add(d, chart, l, run[r], runs > 1 ? label[r] : NULL);
        if (d->curves > before) last = r;
    }
    if (chart->speed && last >= 0) rayleigh_add(d, run[last]);
    postproc_charts_add(charts, &(struct postproc_plot){.folder = folder,
                                                        .name = chart->name,
                                                        .title = chart->title,
                                                        .xlabel = chart->x              ? "x  [mm]"
                                                                  : d->time_unit == 1   ? "t  [s]"
                                                                  : d->time_unit > 1e-4 ? "t  [ms]"
                                                                                        : "t  [{/Symbol m}s]",
                                                        .ylabel = chart->ylabel,
                                                        .curves = d->curves,
                                                        .curve = d->curve});
}

void postproc_charts_crack_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                                const char *const *label, const char *folder) {
    for (int k = 0; k < CHARTS; k++) chart_draw(charts, &all_charts[k], runs, run, label, folder);
}
