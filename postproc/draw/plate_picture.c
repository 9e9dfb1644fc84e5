/* Draws a deformed plate as coloured squares with its damage contour. */
#include "postproc/draw/plate_picture.h"
#include "base/memory.h"
#include "base/sort.h"
#include "postproc/draw/bar.h"
#include "postproc/draw/legend.h"

#include <math.h>

static const unsigned line = 0x0a7d78, paper_top = 0xffffff, paper_bottom = 0xeef0f2;
enum { FINE = 2 };

/* Transform from the plane to the pixels of a canvas. */
struct window {
    double x, y, scale; /* pixel = x + scale X, y - scale Y */
};

static struct window window_of(const struct postproc_plate_picture *p, double fine) {
    const double box[4] = {0.04 * p->width, 0.08 * p->width, 0.86 * p->width, p->height - 0.09 * p->width};
    const struct postproc_plate *plate = p->plate;
    double size[2], middle[2];
    for (int c = 0; c < 2; c++) { /* a margin for moving parts */
        size[c] = 1.06 * (plate->high[c] - plate->low[c]);
        middle[c] = 0.5 * (plate->high[c] + plate->low[c]);
    }
    const double scale = fine * fmin((box[2] - box[0]) / size[0], (box[3] - box[1]) / size[1]);
    return (struct window){fine * 0.5 * (box[0] + box[2]) - scale * middle[0],
                           fine * 0.5 * (box[1] + box[3]) + scale * middle[1], scale};
}

static void squares_draw(struct postproc_canvas *c, const struct postproc_plate_picture *p, const struct window *w) {
    const struct postproc_plate *plate = p->plate;
    for (long i = 0; i < plate->n; i++) {
        double srgb[3];
        const double x = plate->x[i][0] + p->magnify * plate->u[i][0], y = plate->x[i][1] + p->magnify * plate->u[i][1],
                     half = 0.5 * plate->size[i];
        const double left = w->x + w->scale * (x - half), right = w->x + w->scale * (x + half);
        const double top = w->y - w->scale * (y + half), bottom = w->y - w->scale * (y - half);
        if (!(right > 0 && bottom > 0 && left < c->width && top < c->height)) continue;
        const double value = p->value[(size_t)i * (size_t)p->stride];
        postproc_colour_map(p->map, (value - p->value_low) / (p->value_high - p->value_low), srgb);
        for (int k = 0; isnan(value) && k < 3; k++) srgb[k] = 0.86;
        postproc_canvas_fill(c, (int)floor(left), (int)floor(top), (int)ceil(right), (int)ceil(bottom), srgb);
    }
}

static void contour_draw(struct postproc_figure *f, const struct postproc_plate_picture *p, const struct window *w) {
    const struct postproc_contour *contour = p->contour;
    for (int k = 0; contour && k < contour->lines; k++) {
        cairo_new_sub_path(f->cairo);
        for (long i = contour->first[k]; i < contour->first[k + 1]; i++) {
            double at[2];
            for (int a = 0; a < 2; a++) {
                const double u = p->displacement[a] ? postproc_grid_at(p->displacement[a], contour->x[i]) : 0;
                at[a] = contour->x[i][a] + p->magnify * u;
            }
            if (isfinite(at[0] + at[1]))
                cairo_line_to(f->cairo, w->x + w->scale * at[0], w->y - w->scale * at[1]);
            else
                cairo_new_sub_path(f->cairo);
        }
    }
    postproc_figure_stroke(f, line, 1, 1.7);
}

int postproc_plate_picture_draw(const struct postproc_plate_picture *p) {
    const int w = p->width, h = p->height;
    struct postproc_canvas *fine = postproc_canvas_new(FINE * w, FINE * h);
    postproc_canvas_clear(fine, paper_top, paper_bottom);
    const struct window in = window_of(p, FINE), out = window_of(p, 1);
    squares_draw(fine, p, &in);
    struct postproc_figure *f = postproc_figure_new(fine);
    contour_draw(f, p, &out);
    const double text = 0.0106 * w;
    postproc_bar_draw(f, &(struct postproc_bar){.map = p->map,
                                                .low = p->value_low,
                                                .high = p->value_high,
                                                .label = p->label,
                                                .x = (int)(0.89 * w),
                                                .y0 = (int)(0.26 * h),
                                                .y1 = (int)(0.84 * h),
                                                .width = (int)(0.018 * w),
                                                .text = text});
    const double zero[3] = {0, 0, 0}, one[3] = {1, 1, 1}, front[3] = {0, 0, 1};
    struct postproc_camera camera = postproc_camera_new(front, zero, one, (double[4]){0, 0, 1, 1});
    for (int k = 0; k < 3; k++) { /* the two axes of the picture */
        camera.right[k] = k == (p->along == 2 ? 1 : 0);
        camera.up[k] = k == (p->along == 0 ? 1 : 2);
    }
    postproc_legend_axes(f, &camera, zero);
    postproc_legend_scale(f, 0.17 * w, h - 0.035 * w, out.scale, 0.16 * w);
    postproc_legend_title(f, p->title, p->subtitle);
    return postproc_figure_write(f, p->folder, p->name, p->all);
}

double postproc_plate_picture_magnify(const struct postproc_plate *plate) {
    double *size = memory_new(MEMORY_OUTPUT, (size_t)plate->n + 1, sizeof *size);
    for (long i = 0; i < plate->n; i++) size[i] = hypot(plate->u[i][0], plate->u[i][1]);
    sort_ascending(size, (size_t)plate->n);
    const double most = size[(long)(0.99 * (double)(plate->n - 1))];
    const double side = fmax(plate->high[0] - plate->low[0], plate->high[1] - plate->low[1]);
    memory_free(size);
    if (!(most > 0)) return 1;
    const double raw = fmin(0.03 * side / most, 1e6), power = pow(10, floor(log10(raw))), m = raw / power;
    return fmax(1, power * (m < 2 ? 1 : m < 5 ? 2 : 5));
}
