/* Draws the axes, the arrow of the flow and the scale bar. */
#include "postproc/draw/legend.h"

#include <math.h>
#include <stdio.h>

static const unsigned ink = 0x23282e, faint = 0x5a6068;
/* red, green, blue of equal weight, which colour-blind readers tell apart by their letters */
static const unsigned axis_colour[3] = {0xb2182b, 0x1b7837, 0x2166ac};

/* An arrow from a by (ex, ey) pixels. */
static void arrow(struct postproc_figure *f, const double a[2], double ex, double ey, unsigned colour) {
    const double length = hypot(ex, ey), back = 9, wide = 4;
    const double tip[2] = {a[0] + ex, a[1] + ey};
    postproc_figure_line(f, a, tip, colour, 2.2);
    if (length < back) return; /* nearly along the line of sight */
    for (int side = -1; side <= 1; side += 2) {
        const double barb[2] = {tip[0] - (back * ex + side * wide * ey) / length,
                                tip[1] - (back * ey - side * wide * ex) / length};
        postproc_figure_line(f, tip, barb, colour, 2.2);
    }
}

/* Where a direction of length 1 points on the picture; y downward. */
static void project(const struct postproc_camera *camera, const double e[3], double p[2]) {
    p[0] = p[1] = 0;
    for (int c = 0; c < 3; c++) {
        p[0] += e[c] * camera->right[c];
        p[1] -= e[c] * camera->up[c];
    }
}

void postproc_legend_axes(struct postproc_figure *f, const struct postproc_camera *camera, const double flow[3]) {
    static const char *const name[3] = {"x", "y", "z"};
    const double w = f->width, h = f->height, arm = 0.035 * w, text = 0.0106 * w;
    const double origin[2] = {0.075 * w, h - 0.045 * w};
    for (int c = 0; c < 3; c++) {
        double e[3] = {0, 0, 0}, p[2];
        e[c] = 1;
        project(camera, e, p);
        if (hypot(p[0], p[1]) < 0.05) continue; /* along the line of sight */
        arrow(f, origin, arm * p[0], arm * p[1], axis_colour[c]);
        const double out = arm + 0.9 * text / hypot(p[0], p[1]);
        postproc_figure_text(f, origin[0] + out * p[0], origin[1] + out * p[1] + 0.4 * text, text, axis_colour[c],
                             POSTPROC_CENTRE, name[c]);
    }
    const double size = sqrt(flow[0] * flow[0] + flow[1] * flow[1] + flow[2] * flow[2]);
    if (!(size > 0)) return;
    double e[3], p[2];
    for (int c = 0; c < 3; c++) e[c] = flow[c] / size;
    project(camera, e, p);
    const double middle[2] = {0.185 * w, h - 0.055 * w},
                 from[2] = {middle[0] - arm * p[0] * 0.7, middle[1] - arm * p[1] * 0.7};
    arrow(f, from, 1.4 * arm * p[0], 1.4 * arm * p[1], faint);
    postproc_figure_text(f, middle[0], middle[1] + 0.7 * arm * fabs(p[1]) + 1.9 * text, text, faint, POSTPROC_CENTRE,
                         "flow");
}

void postproc_legend_title(struct postproc_figure *f, const char *title, const char *subtitle) {
    const double w = f->width, height[2] = {0.0148 * w, 0.0112 * w}, below[2] = {0.04 * w, 0.0656 * w};
    for (int k = 0; k < 2; k++) {
        const char *text = k ? subtitle : title;
        const double wide = postproc_figure_text_width(f, height[k], text), available = 0.94 * w;
        postproc_figure_text(f, 0.03 * w, below[k], height[k] * (wide > available ? available / wide : 1),
                             k ? faint : ink, POSTPROC_LEFT, text);
    }
}

double postproc_legend_round(double bound) {
    const double power = pow(10, floor(log10(bound) + 1e-12)), m = bound / power;
    return power * (m < 2 - 1e-9 ? 1 : m < 5 - 1e-9 ? 2 : 5);
}

void postproc_legend_length(double metres, char text[32]) {
    static const struct {
        double size;
        const char *name;
    } unit[] = {{1e3, "km"}, {1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}};
    int k = 0;
    while (k < 4 && metres < unit[k].size * (1 - 1e-9)) k++;
    snprintf(text, 32, "%.4g %s", metres / unit[k].size, unit[k].name);
}

void postproc_legend_scale(struct postproc_figure *f, double x, double y, double scale, double most) {
    const double text = 0.0106 * f->width, length = postproc_legend_round(most / scale);
    const double a[2] = {x, y}, b[2] = {x + scale * length, y};
    postproc_figure_line(f, a, b, ink, 2.2);
    for (int end = 0; end < 2; end++) {
        const double top[2] = {end ? b[0] : a[0], y - 5}, low[2] = {top[0], y + 5};
        postproc_figure_line(f, top, low, ink, 2.2);
    }
    char label[32];
    postproc_legend_length(length, label);
    postproc_figure_text(f, 0.5 * (a[0] + b[0]), y - 0.8 * text, text, ink, POSTPROC_CENTRE, label);
}
