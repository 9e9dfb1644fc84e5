/* Colour bar: the scale of colours and values. */
#pragma once
#include "postproc/draw/canvas.h"
#include "postproc/draw/colour.h"

struct postproc_bar {
    enum postproc_map map;
    double low, high;     /* values of its ends */
    const char *label;    /* above it, flush right */
    int x, y0, y1, width; /* pixels; y0 is its top */
    double text;          /* height of capitals, pixels */
    double left;          /* the label begins here at the earliest, pixels */
};
void postproc_bar_draw(struct postproc_canvas *c, const struct postproc_bar *bar);
