/* Places of events as a plot: a disc an event, coloured by its time, the larger the more energy it released. Drawn by
 * gnuplot from NAME.gp, which contains its data. */
#pragma once
#include "postproc/gnuplot.h"

struct postproc_events_plot {
    const char *folder, *name; /* folder/name.gp, .png, .svg, .pdf */
    const char *title;
    const char *time;  /* label of the colour bar */
    char across[2];    /* letters of the axes */
    const double *at[2], *when, *energy; /* [n] m, as in `time`, J */
    long n;
};
enum postproc_plot_status postproc_events_draw(const struct postproc_events_plot *p);
