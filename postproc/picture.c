#include "postproc/picture.h"
#include "base/memory.h"
#include "postproc/font.h"
#include "postproc/render.h"

#include <math.h>
#include <stdio.h>

static const unsigned ink = 0x23282e, faint = 0x7c858f, paper_top = 0xffffff, paper_bottom = 0xe3e7eb;

/* Three to six round numbers between low and high: their step. */
static double tick_step(double low, double high) {
    const double raw = (high - low) / 4, power = pow(10, floor(log10(raw))), m = raw / power;
    return power * (m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10);
}

static void bar_draw(struct postproc_canvas *c, const struct postproc_picture *p, int x, int y0, int y1) {
    const int wide = (int)(0.018 * p->width);
    const double text = 0.0165 * p->height;
    for (int j = y0; j < y1; j++) {
        double srgb[3];
        postproc_colour_map(p->map, 1 - (j + 0.5 - y0) / (y1 - y0), srgb);
        postproc_canvas_fill(c, x, j, x + wide, j + 1, srgb);
    }
    const struct postproc_pen pen = {.colour = ink, .alpha = 0.7, .width = 1.2, .hidden = 1};
    const double corner[5][3] = {{x, y0, 0}, {x + wide, y0, 0}, {x + wide, y1, 0}, {x, y1, 0}, {x, y0, 0}};
    for (int k = 0; k < 4; k++) postproc_canvas_line(c, corner[k], corner[k + 1], pen);
    const double step = tick_step(p->value_low, p->value_high);
    const long first = (long)ceil(p->value_low / step - 1e-6),
               last = (long)floor(p->value_high / step + 1e-6);
    for (long i = first; i <= last; i++) {
        const double v = (double)i * step,
                     y = y1 + (v - p->value_low) / (p->value_high - p->value_low) * (y0 - y1);
        const double a[3] = {x + wide, y, 0}, b[3] = {x + wide + 6, y, 0};
        char number[32];
        snprintf(number, sizeof number, "%.6g", v);
        postproc_canvas_line(c, a, b, pen);
        postproc_font_draw(c, x + wide + 12, y + 0.5 * text, text, ink, number);
    }
    const double over = x + wide - postproc_font_width(text, p->label);
    postproc_font_draw(c, fmax(over, 0.5 * p->width), y0 - 1.4 * text, text, ink, p->label);
}

/* An arrow along the channel's axis below its near edge: where the flow goes. */
static void flow_draw(struct postproc_canvas *c, const struct postproc_picture *p,
                      const struct postproc_camera *camera) {
    const double z = p->toward[2] >= 0 ? 1.13 * p->domain[2] : -0.13 * p->domain[2];
    const double from[3] = {0.02 * p->domain[0], 0, z}, to[3] = {0.26 * p->domain[0], 0, z};
    double a[3], b[3];
    postproc_camera_see(camera, from, a);
    postproc_camera_see(camera, to, b);
    const double ex = b[0] - a[0], ey = b[1] - a[1], length = hypot(ex, ey);
    if (length < 20) return;
    const struct postproc_pen pen = {.colour = faint, .alpha = 1, .width = 2.4, .hidden = 1};
    a[2] = b[2] = 1e30;
    postproc_canvas_line(c, a, b, pen);
    for (int side = -1; side <= 1; side += 2) {
        const double back = 12, wide = 5 * side;
        const double barb[3] = {b[0] - (back * ex + wide * ey) / length,
                                b[1] - (back * ey - wide * ex) / length, 1e30};
        postproc_canvas_line(c, b, barb, pen);
    }
    const double text = 0.0165 * p->height;
    const double width = postproc_font_width(text, "flow");
    postproc_font_draw(c, 0.5 * (a[0] + b[0]) - 0.5 * width, fmax(a[1], b[1]) + 1.2 * text, text, faint,
                       "flow");
}

int postproc_picture_draw(const struct postproc_picture *p) {
    const int w = p->width, h = p->height;
    struct postproc_canvas *fine = postproc_canvas_new(2 * w, 2 * h);
    postproc_canvas_clear(fine, paper_top, paper_bottom);
    float(*colour)[3] = memory_new(MEMORY_OUTPUT, (size_t)(p->n > 0 ? p->n : 1), sizeof *colour);
    for (long i = 0; i < p->n; i++) {
        double srgb[3];
        postproc_colour_map(p->map, (p->value[i] - p->value_low) / (p->value_high - p->value_low), srgb);
        for (int k = 0; k < 3; k++) colour[i][k] = (float)postproc_colour_linear(srgb[k]);
    }
    const double zero[3] = {0, 0, 0};
    const double window[4] = {0.04 * 2 * w, 0.13 * 2 * h, 0.86 * 2 * w, 0.93 * 2 * h};
    const struct postproc_camera camera = postproc_camera_new(p->toward, zero, p->domain, window);
    struct postproc_cubes cubes = {
        .n = p->n, .x = p->x, .colour = (const float(*)[3])colour, .size = p->size};
    for (int k = 0; k < 3; k++) {
        cubes.low[k] = p->low[k];
        cubes.high[k] = p->high[k];
    }
    postproc_render_cubes(fine, &camera, &cubes, 0);
    postproc_render_box(fine, &camera, zero, p->domain,
                        (struct postproc_pen){.colour = ink, .alpha = 0.55, .width = 2.4, .hidden = 0});
    struct postproc_canvas *c = postproc_canvas_halve(fine);
    postproc_canvas_free(fine);
    memory_free(colour);

    const struct postproc_camera half = postproc_camera_new(
        p->toward, zero, p->domain, (double[4]){window[0] / 2, window[1] / 2, window[2] / 2, window[3] / 2});
    flow_draw(c, p, &half);
    bar_draw(c, p, (int)(0.9 * w), (int)(0.28 * h), (int)(0.82 * h));
    postproc_font_draw(c, 0.03 * w, 0.062 * h, 0.023 * h, ink, p->title);
    postproc_font_draw(c, 0.03 * w, 0.102 * h, 0.0175 * h, faint, p->subtitle);
    const int status = postproc_canvas_write(c, p->path);
    postproc_canvas_free(c);
    return status;
}
