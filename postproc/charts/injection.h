/* The record of an injection: pressure and rate over time, with its moments marked. */
#pragma once
#include "postproc/charts/plot.h"

struct postproc_injection_plot {
    const char *folder, *name, *title; /* folder/NAME.png, .svg, .pdf, .gp */
    const char *time;                  /* label of the time's axis */
    long n;
    const double *when, *pressure, *rate; /* [n] as `time` says; Pa, m3/s */
    int marks;
    const struct postproc_mark *mark; /* vertical lines, x as `when` */
    double peak[2];                   /* when and pressure of the breakdown; NAN: none */
};
enum postproc_plot_status postproc_injection_draw(const struct postproc_injection_plot *p);
