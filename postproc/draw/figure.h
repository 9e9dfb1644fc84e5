/* A picture of pixels, lines and texts, drawn by cairo, and written as PNG, SVG and PDF. Lengths are pixels of the PNG,
 * y downward. */
#pragma once
#include "postproc/draw/canvas.h"

#include <cairo.h>

enum postproc_align { POSTPROC_LEFT, POSTPROC_CENTRE, POSTPROC_RIGHT };
enum { POSTPROC_FIGURE_TEXTS = 64 };

struct postproc_figure {
    int width, height;
    cairo_surface_t *pixels; /* the background; owned */
    cairo_t *cairo;          /* records the lines over it; owned */
    int texts;
    struct {
        double x, y, height; /* the baseline's point, capitals' height */
        unsigned colour;
        enum postproc_align align;
        char text[256];
    } text[POSTPROC_FIGURE_TEXTS];
};

/* Begins with the canvas as the background, each two by two pixels of it as one. Frees the canvas. */
struct postproc_figure *postproc_figure_new(struct postproc_canvas *canvas);
/* Strokes cairo's path with round ends. colour: sRGB 0xrrggbb. */
void postproc_figure_stroke(struct postproc_figure *f, unsigned colour, double alpha, double width);
void postproc_figure_line(struct postproc_figure *f, const double a[2], const double b[2], unsigned colour,
                          double width);
void postproc_figure_text(struct postproc_figure *f, double x, double y, double height, unsigned colour,
                          enum postproc_align align, const char *text);
/* The width of a text with capitals of that height. */
double postproc_figure_text_width(struct postproc_figure *f, double height, const char *text);
/* Writes folder/NAME.png, and NAME.svg and NAME.pdf too if `all`, and frees the figure. Returns 0, or -1 when a file
 * could not be written (errno). */
int postproc_figure_write(struct postproc_figure *f, const char *folder, const char *name, int all);
/* Writes a PNG of [height][width] pixels 0xrrggbb. Returns 0, or -1 when it could not be written (errno). */
int postproc_figure_write_pixels(const char *path, int width, int height, const uint32_t *pixel);
