/* Draws a picture of a porous block: lit cubes, domain box, flow arrow, colour bar. */
#include "postproc/draw/picture.h"
#include "base/memory.h"
#include "postproc/draw/bar.h"
#include "postproc/draw/font.h"
#include "postproc/draw/render.h"

#include <math.h>

static const unsigned ink = 0x23282e, faint = 0x7c858f, paper_top = 0xffffff, paper_bottom = 0xe3e7eb;

/* Draws an arrow along the channel's axis below its near edge, in the direction of the flow. */
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
        const double barb[3] = {b[0] - (back * ex + wide * ey) / length, b[1] - (back * ey - wide * ex) / length, 1e30};
        postproc_canvas_line(c, b, barb, pen);
    }
    const double text = 0.0165 * p->height;
    const double width = postproc_font_width(text, "flow");
    postproc_font_draw(c, 0.5 * (a[0] + b[0]) - 0.5 * width, fmax(a[1], b[1]) + 1.2 * text, text, faint, "flow");
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
    struct postproc_cubes cubes = {.n = p->n, .x = p->x, .colour = (const float(*)[3])colour, .size = p->size};
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
    postproc_bar_draw(c, &(struct postproc_bar){.map = p->map,
                                                .low = p->value_low,
                                                .high = p->value_high,
                                                .label = p->label,
                                                .x = (int)(0.9 * w),
                                                .y0 = (int)(0.28 * h),
                                                .y1 = (int)(0.82 * h),
                                                .width = (int)(0.018 * w),
                                                .text = 0.0165 * h,
                                                .left = 0.5 * w});
    postproc_font_draw(c, 0.03 * w, 0.062 * h, 0.023 * h, ink, p->title);
    postproc_font_draw(c, 0.03 * w, 0.102 * h, 0.0175 * h, faint, p->subtitle);
    const int status = postproc_canvas_write(c, p->path);
    postproc_canvas_free(c);
    return status;
}
