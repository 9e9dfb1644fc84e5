/* Axes, scale bar, arrow of the flow and title of a picture. */
#pragma once
#include "postproc/draw/camera.h"
#include "postproc/draw/figure.h"

/* The three axes in the lower left corner and, beside them, an arrow along the flow; flow 0: no arrow. */
void postproc_legend_axes(struct postproc_figure *f, const struct postproc_camera *camera, const double flow[3]);
/* A bar of a round length, at most `most` pixels long, with its left end at (x, y). scale: pixels per m. */
void postproc_legend_scale(struct postproc_figure *f, double x, double y, double scale, double most);
/* Title and, below it, subtitle in the upper left corner; smaller where they would not fit. */
void postproc_legend_title(struct postproc_figure *f, const char *title, const char *subtitle);
/* A length with its unit: "5 mm". */
void postproc_legend_length(double metres, char text[32]);
/* The largest of 1, 2, 5 times a power of ten that is not above the bound. */
double postproc_legend_round(double bound);
