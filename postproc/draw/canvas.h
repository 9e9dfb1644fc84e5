/* Pixels in linear light with a depth for each, on which solids and lines of the flow are drawn. Pixel (i, j) covers
 * [i, i+1] x [j, j+1], j downward. */
#pragma once
#include <stddef.h>
#include <stdint.h>

struct postproc_canvas {
    int width, height;
    float *rgb;   /* [height][width][3] linear light; owned */
    float *depth; /* [height][width] along the line to the camera, larger is nearer; owned */
};

struct postproc_canvas *postproc_canvas_new(int width, int height);
void postproc_canvas_free(struct postproc_canvas *c);
/* Fills with a vertical gradient between two sRGB colours (0xrrggbb), and clears the depth. */
void postproc_canvas_clear(struct postproc_canvas *c, unsigned top, unsigned bottom);
/* The mean of every 2 x 2 pixels, as sRGB 0xrrggbb: pixel [height/2][stride], written. */
void postproc_canvas_halve(const struct postproc_canvas *c, uint32_t *pixel, size_t stride);

/* A pen: sRGB colour, opacity and width in pixels. Behind nearer objects the opacity is multiplied by `hidden`. */
struct postproc_pen {
    unsigned colour;
    double alpha, width, hidden;
};
/* A round-ended line from a to b: x, y in pixels, z the depth; antialiased by its distance. */
void postproc_canvas_line(struct postproc_canvas *c, const double a[3], const double b[3], struct postproc_pen pen);
/* Draws another canvas of the same size over this one, wherever it has a depth: opaque where it is nearer, else with
 * the opacity `through`. */
void postproc_canvas_overlay(struct postproc_canvas *c, const struct postproc_canvas *over, double through);
/* Pixels x0 <= i < x1, y0 <= j < y1 painted with an sRGB colour. */
void postproc_canvas_fill(struct postproc_canvas *c, int x0, int y0, int x1, int y1, const double srgb[3]);
