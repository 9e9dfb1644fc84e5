/* Draws a colour bar with its ticks and labels. */
#include "postproc/draw/bar.h"
#include "postproc/draw/font.h"

#include <math.h>
#include <stdio.h>

static const unsigned ink = 0x23282e;

/* A tick step of round numbers, with three to six ticks between low and high. */
static double tick_step(double low, double high) {
    const double raw = (high - low) / 4, power = pow(10, floor(log10(raw))), m = raw / power;
    return power * (m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10);
}

void postproc_bar_draw(struct postproc_canvas *c, const struct postproc_bar *bar) {
    const int x = bar->x, y0 = bar->y0, y1 = bar->y1, wide = bar->width;
    for (int j = y0; j < y1; j++) {
        double srgb[3];
        postproc_colour_map(bar->map, 1 - (j + 0.5 - y0) / (y1 - y0), srgb);
        postproc_canvas_fill(c, x, j, x + wide, j + 1, srgb);
    }
    const struct postproc_pen pen = {.colour = ink, .alpha = 0.7, .width = 1.2, .hidden = 1};
    const double corner[5][3] = {{x, y0, 0}, {x + wide, y0, 0}, {x + wide, y1, 0}, {x, y1, 0}, {x, y0, 0}};
    for (int k = 0; k < 4; k++) postproc_canvas_line(c, corner[k], corner[k + 1], pen);
    const double step = tick_step(bar->low, bar->high);
    const long first = (long)ceil(bar->low / step - 1e-6), last = (long)floor(bar->high / step + 1e-6);
    for (long i = first; i <= last; i++) {
        const double v = (double)i * step, y = y1 + (v - bar->low) / (bar->high - bar->low) * (y0 - y1);
        const double a[3] = {x + wide, y, 0}, b[3] = {x + wide + 6, y, 0};
        char number[32];
        snprintf(number, sizeof number, "%.6g", v);
        postproc_canvas_line(c, a, b, pen);
        postproc_font_draw(c, x + wide + 12, y + 0.5 * bar->text, bar->text, ink, number);
    }
    const double over = x + wide - postproc_font_width(bar->text, bar->label);
    postproc_font_draw(c, fmax(over, bar->left), y0 - 1.4 * bar->text, bar->text, ink, bar->label);
}
