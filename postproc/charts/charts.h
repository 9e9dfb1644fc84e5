/* The plots of a run's series: one run's, or several over one another. */
#pragma once
#include "postproc/charts/plot.h"
#include "postproc/data/history.h"

/* What has been drawn: names of the plots ("pressure_drop"), for the report. */
enum { POSTPROC_CHARTS = 24 };
struct postproc_charts {
    int n;
    const char *name[POSTPROC_CHARTS], *title[POSTPROC_CHARTS];
    enum postproc_plot_status worst;
};

/* Draws into the folder all charts of which the runs have columns. label: one a run. */
void postproc_charts_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                          const char *const *label, const char *folder);
/* The same of what their crack.csv have: the way, speed, length and energy of the crack. */
void postproc_charts_crack_draw(struct postproc_charts *charts, int runs, struct postproc_history *const *run,
                                const char *const *label, const char *folder);
/* Draws the plot unless it has no curve, and notes it. */
void postproc_charts_add(struct postproc_charts *charts, const struct postproc_plot *plot);
