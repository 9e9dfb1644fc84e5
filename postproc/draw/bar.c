/* Draws a colour bar with its ticks, numbers and label. */
#include "postproc/draw/bar.h"
#include "postproc/gnuplot.h"

#include <math.h>
#include <stdio.h>

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

/* The maps are linear between 10 or 11 colours, so their common refinement gives them exactly. */
static void draw_colours(struct postproc_figure *f, const struct postproc_bar *bar) {
    enum { PIECES = 90 };
    cairo_pattern_t *gradient = cairo_pattern_create_linear(0, bar->y1, 0, bar->y0);
    for (int k = 0; k <= PIECES; k++) {
        double srgb[3];
        postproc_colour_map(bar->map, (double)k / PIECES, srgb);
        cairo_pattern_add_color_stop_rgb(gradient, (double)k / PIECES, srgb[0], srgb[1], srgb[2]);
    }
    cairo_rectangle(f->cairo, bar->x, bar->y0, bar->width, bar->y1 - bar->y0);
    cairo_set_source(f->cairo, gradient);
    cairo_fill_preserve(f->cairo);
    cairo_pattern_destroy(gradient);
}

/* "10" and the number raised. */
static void raised(int power, char text[32]) {
    static const char *const digit[10] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    size_t at = (size_t)snprintf(text, 32, "×10");
    snprintf(plain, sizeof plain, "%d", power);
    for (const char *c = plain; *c; c++)
        at += (size_t)snprintf(text + at, 32 - at, "%s", *c == '-' ? "⁻" : digit[*c - '0']);
}

void postproc_bar_draw(struct postproc_figure *f, const struct postproc_bar *bar) {
    const struct postproc_bar_ticks ticks = postproc_bar_scale(bar);
    const int power = postproc_gnuplot_power(fmax(fabs(bar->low), fabs(bar->high)));
    const double right = bar->x + bar->width, unit = pow(10, power);
    draw_colours(f, bar);
    for (int i = 0; i < ticks.n; i++) {
        char number[32];
        snprintf(number, sizeof number, "%.6g", ticks.value[i] / unit);
        postproc_figure_text(f, right + 12, ticks.y[i] + 0.5 * bar->text, bar->text, ink, POSTPROC_LEFT, number);
        cairo_move_to(f->cairo, right, ticks.y[i]);
        cairo_line_to(f->cairo, right + 6, ticks.y[i]);
    }
    postproc_figure_stroke(f, ink, 0.7, 1.2); /* the frame and the ticks */
    char factor[32] = "";
    if (power != 0) raised(power, factor);
    postproc_figure_text(f, bar->x, bar->y0 - 1.4 * bar->text, bar->text, ink, POSTPROC_LEFT, factor);
    postproc_figure_text(f, bar->x, bar->y0 - (power ? 3.4 : 1.4) * bar->text, bar->text, ink, POSTPROC_LEFT,
                         bar->label);
}
