/* Maps of values at the corners of quadrilaterals. Neighbours do not share corners, so a value may jump from one to the
 * next. On the left is the whole, on the right a magnified part of it. */
#pragma once
#include "postproc/draw/colour.h"
#include "postproc/gnuplot.h"

/* A line of the drawing, or points. */
struct postproc_patches_line {
    long n;
    const double (*x)[2]; /* [n] m; NaN begins a new line */
    const char *style;    /* gnuplot: "with lines lc rgb '#000000'" */
    int detail;           /* 1: only in the magnified part */
};

struct postproc_patches {
    const char *folder, *name, *title, *subtitle, *label; /* folder/name.gp, .png, .svg, .pdf; label: of the colours */
    long quads;
    const double (*x)[2];   /* [4 quads] corners one after the other, m */
    const double *value;    /* [4 quads]; NULL: none are coloured */
    double low[2], high[2]; /* of the whole, m */
    double centre[2], half; /* of the part, m; half 0: none */
    enum postproc_map map;
    int lines;
    const struct postproc_patches_line *line;
};

enum postproc_plot_status postproc_patches_draw(const struct postproc_patches *p);
