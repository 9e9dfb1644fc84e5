/* Plots of a run's series: of one run, or of several in one plot. */
#pragma once
#include "postproc/charts/plot.h"
#include "postproc/data/history.h"

/* Names of the plots that have been drawn ("pressure_drop"), for the report. */
enum { POSTPROC_CHARTS = 48 };
struct postproc_charts {
    int n;
    const char *name[POSTPROC_CHARTS], *title[POSTPROC_CHARTS];
    enum postproc_plot_status worst;
};

/* Draws into the folder all charts whose columns the runs have. label: one for each run. */
void postproc_charts_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                          const char *const *label, const char *folder);
/* The same for the columns of crack.csv: position, speed, length and energy of the crack. */
void postproc_charts_crack_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                                const char *const *label, const char *folder);
/* Of one run's reactions.csv: forces of constraints and loads over time, and of those that move
 * over their displacement. */
void postproc_charts_reactions_draw(struct postproc_charts *charts, const struct postproc_history *h,
                                    const char *folder);
/* Of one run's slices.csv and rev.csv: porosity and solid area of the slices; porosity and k of sub-volumes over their
 * size. */
void postproc_charts_texture_draw(struct postproc_charts *charts, const struct postproc_history *h, const char *folder);
/* Of one run's intrinsic.csv: the intrinsic permeability over time, beside the apparent one. */
void postproc_charts_intrinsic_draw(struct postproc_charts *charts, const struct postproc_history *h,
                                    const char *folder);
/* Adds the name of a plot that has been drawn; else keeps its status. */
void postproc_charts_note(struct postproc_charts *charts, enum postproc_plot_status status, const char *name,
                          const char *title);
/* Draws the plot and adds its name, unless the plot has no curve. */
void postproc_charts_add(struct postproc_charts *charts, const struct postproc_plot *plot);
