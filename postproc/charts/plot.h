/* Plots by gnuplot, as PNG, SVG and PDF. The script NAME.gp is written beside them, contains its data, and can be run
 * again. */
#pragma once
#include "postproc/gnuplot.h"

struct postproc_curve {
    const char *title;
    long n;
    const double *x, *y;      /* [n]; NaN makes a gap */
    const double *band;       /* [n][4], from low to high: the middle two bound a shaded band, the outer two are dotted
                               * lines; NULL: none */
    int points;               /* 1: points joined by lines */
    int bars;                 /* 1: a histogram, with steps between the bins */
    const char *const *label; /* [n]: labelled points joined by lines; NULL: a line */
};
struct postproc_mark { /* a vertical line */
    double x;
    const char *label;
};
struct postproc_level { /* a horizontal line */
    double y;
    const char *label;
};
struct postproc_plot {
    const char *folder, *name;   /* folder/name.gp, .png, .svg, .pdf */
    const char *title;           /* used unchanged */
    const char *xlabel, *ylabel; /* gnuplot's enhanced text */
    int curves;
    const struct postproc_curve *curve;
    int marks;
    const struct postproc_mark *mark;
    int levels;
    const struct postproc_level *level;
    int log_x, log_y;
    int whole;            /* 1: the axis spans all values; 0: it may leave out spikes */
    double x_low, x_high; /* equal: from the data */
};

/* A unit, in m, in which a length of that size has one to three digits before the point, and its name. */
double postproc_plot_unit(double size, const char **name);
enum postproc_plot_status postproc_plot_draw(const struct postproc_plot *p);
