/* Plots error against run time. */
#include "base/arena.h"
#include "postproc/charts/plot.h"
#include "program/study/report/report.h"

#include <math.h>
#include <stdlib.h>

/* A method's curve: its points with an error and a time. */
static struct postproc_curve curve_new(const struct study_result *r, const struct study_table *t, int method) {
    const struct study *s = r->plan->study;
    double *time = arena_new((size_t)s->levels.n, sizeof *time), *error = arena_new((size_t)s->levels.n, sizeof *error);
    const char **label =
        s->levels.n > 1 ? arena_new((size_t)s->levels.n, sizeof *label) : NULL; /* one level's name says nothing */
    long n = 0;
    for (int l = 0; l < s->levels.n; l++) {
        const struct study_point *p = study_result_point(r, t, method, l);
        if (!(p->relative > 0) || !(p->wall > 0)) continue;
        time[n] = p->wall;
        error[n] = p->relative;
        if (label) label[n] = s->levels.variant[l].name;
        n++;
    }
    const struct study_curve *c = &t->curve[method];
    char *title = isnan(c->gain) ? arena_text("%s", s->methods.variant[method].name)
                  : isnan(c->order)
                      ? arena_text("%s: slope %.2f", s->methods.variant[method].name, c->gain)
                      : arena_text("%s: slope %.2f, order %.2f", s->methods.variant[method].name, c->gain, c->order);
    return (struct postproc_curve){.title = title, .n = n, .x = time, .y = error, .label = label, .points = 1};
}

/* The least error that is drawn; infinity: none. */
static double least_of(const struct postproc_curve *curve, int curves) {
    double least = INFINITY;
    for (int k = 0; k < curves; k++)
        for (long i = 0; i < curve[k].n; i++) least = fmin(least, curve[k].y[i]);
    return least;
}

/* Draws a table's plot, if it has two points or more. Returns whether gnuplot succeeded. */
static int draw(const struct study_result *r, struct study_table *t, const char *out) {
    const struct study *s = r->plan->study;
    struct postproc_curve *curve = arena_new((size_t)s->methods.n, sizeof *curve);
    long points = 0;
    int curves = 0;
    for (int m = 0; m < s->methods.n; m++) {
        curve[curves] = curve_new(r, t, m);
        points += curve[curves].n;
        curves += curve[curves].n > 0;
    }
    const struct postproc_level level = {t->uncertainty / t->scale, "uncertainty of the reference"};
    const int level_counts = level.y > 0.01 * least_of(curve, curves); /* far below it would take all of the axis */
    char *name = study_report_name(r, t), *title = arena_text("%s: %s", s->title, t->quantity->name);
    const enum postproc_plot_status status = points < 2 ? POSTPROC_PLOT_DONE
                                                        : postproc_plot_draw(&(struct postproc_plot){
                                                              .folder = out,
                                                              .name = name,
                                                              .title = title,
                                                              .xlabel = "wall time of the steps  [s], median",
                                                              .ylabel = t->has_scale ? "relative error" : "error",
                                                              .curves = curves,
                                                              .curve = curve,
                                                              .levels = level.y > 0 && level_counts,
                                                              .level = &level,
                                                              .log_x = 1,
                                                              .log_y = 1,
                                                          });
    t->plotted = points > 1 && status == POSTPROC_PLOT_DONE;
    return status == POSTPROC_PLOT_DONE;
}

int study_chart_draw(struct study_result *r, const char *out) {
    int all = 1;
    for (int q = 0; q < r->tables; q++) all &= draw(r, &r->table[q], out);
    return all;
}
