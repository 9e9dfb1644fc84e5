/* Draws a colour bar with the marks of its ticks. */
#include "postproc/draw/bar.h"

#include <math.h>

static const unsigned ink = 0x23282e;

/* A tick step of round numbers, with three to six ticks between low and high. */
static double tick_step(double low, double high) {
    const double raw = (high - low) / 4, power = pow(10, floor(log10(raw))), m = raw / power;
    return power * (m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10);
}

struct postproc_bar_ticks postproc_bar_scale(const struct postproc_bar *bar) {
    struct postproc_bar_ticks ticks = {0};
    if (!(bar->high > bar->low)) return ticks;
    const double step = tick_step(bar->low, bar->high);
    const long first = (long)ceil(bar->low / step - 1e-6), last = (long)floor(bar->high / step + 1e-6);
    for (long i = first; i <= last && ticks.n < POSTPROC_BAR_TICKS; i++, ticks.n++) {
        ticks.value[ticks.n] = (double)i * step;
        ticks.y[ticks.n] = bar->y1 + (ticks.value[ticks.n] - bar->low) / (bar->high - bar->low) * (bar->y0 - bar->y1);
    }
    return ticks;
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
    const struct postproc_bar_ticks ticks = postproc_bar_scale(bar);
    for (int i = 0; i < ticks.n; i++) {
        const double a[3] = {x + wide, ticks.y[i], 0}, b[3] = {x + wide + 6, ticks.y[i], 0};
        postproc_canvas_line(c, a, b, pen);
    }
}
