/* Tips of the initial cracks, the damage level of a crack, and the chord from tip to end. */
#include "postproc/data/crack_shape.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

static const double CLOSE = 0.98;

int postproc_crack_shape_tips(const struct postproc_grid *g, int cracks, const struct scene_crack *crack,
                              struct postproc_tip *tip) {
    int n = 0;
    for (int k = 0; k < cracks; k++)
        for (int end = 0; end < 2; end++) {
            const struct scene_crack *c = &crack[k];
            const double *x = c->point[end ? c->points - 1 : 0], *y = c->point[end ? c->points - 2 : 1];
            const double l = hypot(x[0] - y[0], x[1] - y[1]);
            const double d[2] = {(x[0] - y[0]) / l, (x[1] - y[1]) / l};
            const double beyond[2] = {x[0] + 3 * g->h * d[0], x[1] + 3 * g->h * d[1]};
            if (isnan(postproc_grid_at(g, beyond))) continue;
            tip[n++] = (struct postproc_tip){{x[0], x[1]}, {d[0], d[1]}, c};
        }
    return n;
}

/* Calls for points a quarter of a node apart along a crack. */
static void along(const struct scene_crack *c, double step, void (*see)(void *with, const double x[2]), void *with) {
    for (int k = 0; k + 1 < c->points; k++) {
        const double *a = c->point[k], *b = c->point[k + 1];
        const long pieces = lround(hypot(b[0] - a[0], b[1] - a[1]) / step) + 1;
        for (long i = 0; i <= pieces; i++) {
            const double f = (double)i / (double)pieces;
            see(with, (double[]){a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])});
        }
    }
}

struct lowest {
    const struct postproc_grid *damage;
    int tips;
    const struct postproc_tip *tip;
    double margin, value;
};

static void lower(void *with, const double x[2]) {
    struct lowest *l = with;
    for (int k = 0; k < l->tips; k++)
        if (hypot(x[0] - l->tip[k].x[0], x[1] - l->tip[k].x[1]) < l->margin) return;
    const double value = postproc_grid_at(l->damage, x);
    if (!isnan(value)) l->value = fmin(l->value, value);
}

double postproc_crack_shape_level(const struct postproc_grid *damage, int cracks, const struct scene_crack *crack,
                                  double margin) {
    struct postproc_tip *tip = memory_new(MEMORY_OUTPUT, 2 * (size_t)cracks + 1, sizeof *tip);
    struct lowest l = {damage, postproc_crack_shape_tips(damage, cracks, crack, tip), tip, margin, INFINITY};
    for (int k = 0; k < cracks; k++) along(&crack[k], 0.25 * damage->h, lower, &l);
    memory_free(tip);
    return isfinite(l.value) && l.value > 0 ? CLOSE * l.value : NAN;
}

enum { REACH = 3 };

struct postproc_grid *postproc_crack_shape_connected(const struct postproc_grid *g, double level, const double x[2]) {
    struct postproc_grid *c = postproc_grid_empty(g->n[0], g->n[1], g->origin, g->h);
    const size_t nodes = (size_t)g->n[0] * (size_t)g->n[1];
    int(*stack)[2] = memory_new(MEMORY_OUTPUT, nodes + 1, sizeof *stack);
    size_t n = 0;
    stack[n][0] = (int)lround((x[0] - g->origin[0]) / g->h);
    stack[n++][1] = (int)lround((x[1] - g->origin[1]) / g->h);
    while (n > 0) {
        const int i = stack[--n][0], j = stack[n][1];
        for (int b = j - REACH; b <= j + REACH; b++)
            for (int a = i - REACH; a <= i + REACH; a++) {
                const double value = postproc_grid_value(g, a, b);
                if (!(value > level) || !isnan(postproc_grid_value(c, a, b))) continue;
                c->value[(size_t)b * (size_t)c->n[0] + (size_t)a] = value;
                stack[n][0] = a;
                stack[n++][1] = b;
            }
    }
    memory_free(stack);
    return c;
}

struct far {
    const struct postproc_grid *g;
    char *initial; /* [n1][n0] 1: next to an initial crack */
};

static void mark(void *with, const double x[2]) {
    struct far *f = with;
    const int i = (int)lround((x[0] - f->g->origin[0]) / f->g->h), j = (int)lround((x[1] - f->g->origin[1]) / f->g->h);
    for (int b = j - 2; b <= j + 2; b++)
        for (int a = i - 2; a <= i + 2; a++)
            if (a >= 0 && b >= 0 && a < f->g->n[0] && b < f->g->n[1])
                f->initial[(size_t)b * (size_t)f->g->n[0] + (size_t)a] = 1;
}

struct postproc_chord postproc_crack_shape_chord(const struct postproc_grid *g, const struct postproc_tip *tip) {
    struct far f = {g, memory_new(MEMORY_OUTPUT, (size_t)g->n[0] * (size_t)g->n[1] + 1, 1)};
    struct postproc_chord c = {0, {NAN, NAN}, 0, {NAN, NAN}};
    along(tip->crack, 0.5 * g->h, mark, &f);
    for (int j = 0; j < g->n[1]; j++)
        for (int i = 0; i < g->n[0]; i++) {
            const size_t at = (size_t)j * (size_t)g->n[0] + (size_t)i;
            if (isnan(g->value[at]) || f.initial[at]) continue;
            const double x[2] = {g->origin[0] + i * g->h, g->origin[1] + j * g->h};
            const double length = hypot(x[0] - tip->x[0], x[1] - tip->x[1]);
            if (length <= c.length) continue;
            c.found = 1;
            c.length = length;
            memcpy(c.end, x, sizeof c.end);
        }
    memory_free(f.initial);
    if (!c.found) return c;
    const double dx = c.end[0] - tip->x[0], dy = c.end[1] - tip->x[1], *d = tip->direction;
    c.angle.value = fabs(atan2(d[0] * dy - d[1] * dx, d[0] * dx + d[1] * dy)) * 180 / M_PI;
    c.angle.error = atan(g->h / c.length) * 180 / M_PI; /* the end has an error of one node */
    return c;
}
