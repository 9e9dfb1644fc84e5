/* Pixels in linear light with a depth buffer: background, lines, rectangles. */
#include "postproc/draw/canvas.h"
#include "base/memory.h"
#include "postproc/draw/colour.h"

#include <math.h>
#include <stddef.h>

static void unpack(unsigned colour, double linear[3]) {
    for (int c = 0; c < 3; c++) linear[c] = postproc_colour_linear((colour >> (16 - 8 * c) & 255) / 255.0);
}

struct postproc_canvas *postproc_canvas_new(int width, int height) {
    struct postproc_canvas *c = memory_new(MEMORY_OUTPUT, 1, sizeof *c);
    const size_t n = (size_t)width * (size_t)height;
    *c = (struct postproc_canvas){.width = width, .height = height};
    c->rgb = memory_new(MEMORY_OUTPUT, 3 * n, sizeof *c->rgb);
    c->depth = memory_new(MEMORY_OUTPUT, n, sizeof *c->depth);
    for (size_t i = 0; i < n; i++) c->depth[i] = -INFINITY;
    return c;
}

void postproc_canvas_free(struct postproc_canvas *c) {
    if (!c) return;
    MEMORY_FREE(c->rgb, c->depth, c);
}

void postproc_canvas_clear(struct postproc_canvas *c, unsigned top, unsigned bottom) {
    double a[3], b[3];
    unpack(top, a);
    unpack(bottom, b);
    for (int j = 0; j < c->height; j++) {
        const double f = (j + 0.5) / c->height;
        for (int i = 0; i < c->width; i++) {
            const size_t at = (size_t)j * (size_t)c->width + (size_t)i;
            for (int k = 0; k < 3; k++) c->rgb[3 * at + (size_t)k] = (float)(a[k] + f * (b[k] - a[k]));
            c->depth[at] = -INFINITY;
        }
    }
}

void postproc_canvas_line(struct postproc_canvas *c, const double a[3], const double b[3], struct postproc_pen pen) {
    const double r = 0.5 * pen.width, reach = r + 1;
    const int i0 = (int)fmax(0, floor(fmin(a[0], b[0]) - reach));
    const int i1 = (int)fmin(c->width - 1, ceil(fmax(a[0], b[0]) + reach));
    const int j0 = (int)fmax(0, floor(fmin(a[1], b[1]) - reach));
    const int j1 = (int)fmin(c->height - 1, ceil(fmax(a[1], b[1]) + reach));
    const double ex = b[0] - a[0], ey = b[1] - a[1], ee = ex * ex + ey * ey;
    double colour[3];
    unpack(pen.colour, colour);
    for (int j = j0; j <= j1; j++)
        for (int i = i0; i <= i1; i++) {
            const double x = i + 0.5 - a[0], y = j + 0.5 - a[1];
            const double t = ee > 0 ? fmin(fmax((x * ex + y * ey) / ee, 0), 1) : 0;
            const double cover = fmin(fmax(r + 0.5 - hypot(x - t * ex, y - t * ey), 0), 1) * fmin(pen.width, 1);
            if (cover <= 0) continue;
            const size_t at = (size_t)j * (size_t)c->width + (size_t)i;
            const int hidden = c->depth[at] > (float)(a[2] + t * (b[2] - a[2]));
            const float f = (float)(cover * pen.alpha * (hidden ? pen.hidden : 1));
            for (size_t k = 0; k < 3; k++) c->rgb[3 * at + k] += f * ((float)colour[k] - c->rgb[3 * at + k]);
        }
}

void postproc_canvas_overlay(struct postproc_canvas *c, const struct postproc_canvas *over, double through) {
    const size_t all = (size_t)c->width * (size_t)c->height;
    for (size_t i = 0; i < all; i++) {
        if (over->depth[i] == -INFINITY) continue;
        const int nearer = over->depth[i] >= c->depth[i];
        const float f = nearer ? 1 : (float)through;
        for (size_t k = 0; k < 3; k++) c->rgb[3 * i + k] += f * (over->rgb[3 * i + k] - c->rgb[3 * i + k]);
        if (nearer) c->depth[i] = over->depth[i];
    }
}

void postproc_canvas_fill(struct postproc_canvas *c, int x0, int y0, int x1, int y1, const double srgb[3]) {
    float colour[3];
    for (int k = 0; k < 3; k++) colour[k] = (float)postproc_colour_linear(srgb[k]);
    for (int j = y0 < 0 ? 0 : y0; j < y1 && j < c->height; j++)
        for (int i = x0 < 0 ? 0 : x0; i < x1 && i < c->width; i++)
            for (int k = 0; k < 3; k++) c->rgb[3 * ((size_t)j * (size_t)c->width + (size_t)i) + (size_t)k] = colour[k];
}

void postproc_canvas_halve(const struct postproc_canvas *c, uint32_t *pixel, size_t stride) {
    enum { STEPS = 4096 };
    unsigned char srgb[STEPS + 1];
    for (int i = 0; i <= STEPS; i++) srgb[i] = (unsigned char)lround(255 * postproc_colour_srgb((double)i / STEPS));
    const size_t w = 3 * (size_t)c->width;
    for (size_t j = 0; j < (size_t)c->height / 2; j++)
        for (size_t i = 0; i < (size_t)c->width / 2; i++) {
            const float *a = c->rgb + 2 * (j * w + 3 * i), *b = a + w;
            uint32_t packed = 0;
            for (size_t k = 0; k < 3; k++) {
                const float mean = 0.25f * (a[k] + a[3 + k] + b[k] + b[3 + k]);
                packed = packed << 8 | srgb[(int)(fminf(fmaxf(mean, 0), 1) * STEPS + 0.5f)];
            }
            pixel[j * stride + i] = packed;
        }
}
