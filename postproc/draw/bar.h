/* Colour bar: the scale of colours and values. */
#pragma once
#include "postproc/draw/colour.h"
#include "postproc/draw/figure.h"

struct postproc_bar {
    enum postproc_map map;
    double low, high;     /* values of its ends */
    const char *label;    /* above it */
    int x, y0, y1, width; /* pixels; y0 is its top */
    double text;          /* height of capitals, pixels */
};
enum { POSTPROC_BAR_TICKS = 12 };
struct postproc_bar_ticks {
    int n;
    double value[POSTPROC_BAR_TICKS], y[POSTPROC_BAR_TICKS]; /* y: pixels */
};
/* Round values between the ends: three to six. */
struct postproc_bar_ticks postproc_bar_scale(const struct postproc_bar *bar);
/* The bar with its ticks, numbers and label; one power of ten for all numbers, below the label. */
void postproc_bar_draw(struct postproc_figure *f, const struct postproc_bar *bar);
