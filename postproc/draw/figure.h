/* A picture with its texts. gnuplot sets them, in the typeface of the plots; without gnuplot they are drawn by the
 * stroke font. */
#pragma once
#include "postproc/draw/bar.h"
#include "postproc/draw/canvas.h"
#include "postproc/gnuplot.h"

enum postproc_align { POSTPROC_LEFT, POSTPROC_CENTRE, POSTPROC_RIGHT };
enum { POSTPROC_FIGURE_TEXTS = 64 };

struct postproc_figure {
    struct postproc_canvas *canvas; /* owned */
    int texts;
    struct {
        double x, y, height; /* pixels: the baseline's point, capitals' height */
        unsigned colour;
        enum postproc_align align;
        char text[256];
    } text[POSTPROC_FIGURE_TEXTS];
};

/* Takes the canvas. */
struct postproc_figure *postproc_figure_new(struct postproc_canvas *canvas);
void postproc_figure_text(struct postproc_figure *f, double x, double y, double height, unsigned colour,
                          enum postproc_align align, const char *text);
/* The bar with its ticks, numbers and label; one power of ten for all numbers, behind the label. */
void postproc_figure_bar(struct postproc_figure *f, const struct postproc_bar *bar);
/* Writes folder/NAME.png, and NAME.svg and NAME.pdf too if `all`, and frees the figure. Without gnuplot only NAME.png
 * is written. Returns 0, or -1 when a file could not be written (errno). */
int postproc_figure_write(struct postproc_figure *f, const char *folder, const char *name, int all);
