/* Draws a picture of space: lit cubes, lines and planes of the flow, domain box, axes, scale, colour bars. */
#include "postproc/draw/picture.h"
#include "base/memory.h"
#include "postproc/draw/bar.h"
#include "postproc/draw/legend.h"

#include <math.h>

static const unsigned ink = 0x23282e, paper_top = 0xffffff, paper_bottom = 0xe3e7eb;
static const double stone[3] = {0.80, 0.79, 0.77}; /* sRGB of a solid without values */
enum { FINE = 2 };

static void solid_draw(struct postproc_canvas *canvas, const struct postproc_picture *p,
                       const struct postproc_camera *camera) {
    if (p->n <= 0) return;
    float(*colour)[3] = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *colour);
    for (long i = 0; i < p->n; i++) {
        double srgb[3] = {stone[0], stone[1], stone[2]};
        if (p->value) postproc_colour_map(p->map, (p->value[i] - p->value_low) / (p->value_high - p->value_low), srgb);
        for (int k = 0; k < 3; k++) colour[i][k] = (float)postproc_colour_linear(srgb[k]);
    }
    struct postproc_cubes cubes = {.n = p->n, .x = p->x, .colour = (const float(*)[3])colour, .size = p->size};
    for (int k = 0; k < 3; k++) {
        cubes.low[k] = p->low[k];
        cubes.high[k] = p->high[k];
    }
    postproc_render_cubes(canvas, camera, &cubes, 0);
    memory_free(colour);
}

/* Draws the lines alone, then lays them over or under the canvas by their depth. */
static void stream_draw(struct postproc_canvas *canvas, const struct postproc_picture *p,
                        const struct postproc_camera *camera) {
    const struct postproc_stream *s = p->stream;
    struct postproc_canvas *alone = postproc_canvas_new(canvas->width, canvas->height);
    for (int k = 0; k < s->lines; k++)
        for (long i = s->first[k]; i + 1 < s->first[k + 1]; i++) {
            double a[3], b[3], end[2][3], srgb[3];
            for (int c = 0; c < 3; c++) { /* both ends by the same period */
                const double shift = p->domain[c] * floor(0.5 * (s->x[i][c] + s->x[i + 1][c]) / p->domain[c]);
                a[c] = s->x[i][c] - shift;
                b[c] = s->x[i + 1][c] - shift;
            }
            postproc_camera_see(camera, a, end[0]);
            postproc_camera_see(camera, b, end[1]);
            const double speed = 0.5 * (s->speed[i] + s->speed[i + 1]);
            postproc_colour_map(p->flow_map, (speed - p->flow_low) / (p->flow_high - p->flow_low), srgb);
            postproc_render_tube(alone, end[0], end[1], 1.5 * FINE, 1 / camera->scale, srgb);
        }
    postproc_canvas_overlay(canvas, alone, p->through);
    postproc_canvas_free(alone);
}

static void bars_draw(struct postproc_figure *f, const struct postproc_picture *p) {
    const int w = p->width, h = p->height, solid = p->n > 0 && p->value, flow = p->stream || p->planes;
    struct postproc_bar bar = {.x = (int)(0.89 * w), .width = (int)(0.018 * w), .text = 0.0165 * h};
    if (flow) {
        bar.map = p->flow_map;
        bar.low = p->flow_low;
        bar.high = p->flow_high;
        bar.label = p->flow_label;
        bar.y0 = (int)((solid ? 0.22 : 0.3) * h);
        bar.y1 = (int)((solid ? 0.48 : 0.8) * h);
        postproc_bar_draw(f, &bar);
    }
    if (solid) {
        bar.map = p->map;
        bar.low = p->value_low;
        bar.high = p->value_high;
        bar.label = p->label;
        bar.y0 = (int)((flow ? 0.62 : 0.3) * h);
        bar.y1 = (int)((flow ? 0.88 : 0.8) * h);
        postproc_bar_draw(f, &bar);
    }
}

int postproc_picture_draw(const struct postproc_picture *p) {
    const int w = p->width, h = p->height;
    struct postproc_canvas *fine = postproc_canvas_new(FINE * w, FINE * h);
    postproc_canvas_clear(fine, paper_top, paper_bottom);
    const double zero[3] = {0, 0, 0};
    const double window[4] = {0.04 * FINE * w, 0.13 * FINE * h, 0.86 * FINE * w, 0.86 * FINE * h};
    const struct postproc_camera camera = postproc_camera_new(p->toward, zero, p->domain, window);
    solid_draw(fine, p, &camera);
    for (int k = 0; k < p->planes; k++)
        postproc_render_plane(fine, &camera, &p->plane[k], p->flow_map, p->flow_low, p->flow_high);
    if (p->stream) stream_draw(fine, p, &camera);
    postproc_render_box(fine, &camera, zero, p->domain,
                        (struct postproc_pen){.colour = ink, .alpha = 0.55, .width = 1.2 * FINE, .hidden = 0});
    struct postproc_figure *f = postproc_figure_new(fine);
    struct postproc_camera half = camera;
    half.scale /= FINE;
    postproc_legend_axes(f, &half, p->flow);
    postproc_legend_scale(f, 0.27 * w, h - 0.035 * w, half.scale, 0.16 * w);
    bars_draw(f, p);
    postproc_legend_title(f, p->title, p->subtitle);
    return postproc_figure_write(f, p->folder, p->name, p->all);
}
