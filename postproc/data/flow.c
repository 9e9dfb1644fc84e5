/* Reads the velocity of a fluid and interpolates it. */
#include "postproc/data/flow.h"
#include "base/memory.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>

enum { SAMPLE = 1000000 }; /* at most so many speeds enter the quantile */

static enum postproc_beyond beyond_of(enum fluid_side_type type) {
    switch (type) {
    case FLUID_PERIODIC:
        return POSTPROC_BEYOND_WRAP;
    case FLUID_WALL:
        return POSTPROC_BEYOND_MIRROR;
    case FLUID_SLIP:
    case FLUID_INFLOW:
    case FLUID_OUTFLOW:
    case FLUID_PRESSURE:
    case FLUID_GENERAL:
        break;
    }
    return POSTPROC_BEYOND_COPY;
}

void postproc_flow_sides(struct postproc_flow *f, const struct scene *scene) {
    for (int c = 0; c < 3; c++)
        for (int side = 0; side < 2; side++) {
            const struct scene_side *s = &scene->fluid->side[c][side];
            f->beyond[c][side] = beyond_of(s->type);
            for (int a = 0; a < 3; a++)
                f->wall[c][side][a] = f->beyond[c][side] == POSTPROC_BEYOND_MIRROR ? s->velocity[a] : 0;
        }
}

/* Mean, largest speed and bound, from u and solid. */
static void measure(struct postproc_flow *f) {
    const size_t all = (size_t)f->n[0] * (size_t)f->n[1] * (size_t)f->n[2], stride = all / SAMPLE + 1;
    double *speed = memory_new(MEMORY_OUTPUT, all / stride + 1, sizeof *speed), sum[3] = {0, 0, 0};
    size_t m = 0, fluid = 0;
    f->fastest = f->bound = 0;
    for (size_t at = 0; at < all; at++) {
        if (f->solid && !(f->solid[at] < 0.5F)) continue;
        const float *u = f->u[at];
        const double size = sqrt((double)u[0] * u[0] + (double)u[1] * u[1] + (double)u[2] * u[2]);
        for (int c = 0; c < 3; c++) sum[c] += u[c];
        f->fastest = fmax(f->fastest, size);
        if (fluid++ % stride == 0) speed[m++] = size;
    }
    sort_ascending(speed, m);
    if (m > 0) f->bound = speed[(size_t)(0.999 * (double)(m - 1))];
    for (int c = 0; c < 3; c++) f->mean[c] = fluid ? sum[c] / (double)fluid : 0;
    memory_free(speed);
}

/* Reads a field plane by plane as floats, which it is stored as. */
static float *floats(struct vtkhdf_source *s, const char *name, int comps) {
    const size_t plane = (size_t)comps * (size_t)s->n[0] * (size_t)s->n[1];
    const int m[3] = {s->n[0], s->n[1], 1};
    float *value = memory_new(MEMORY_OUTPUT, plane * (size_t)s->n[2], sizeof *value);
    for (int k = 0; k < s->n[2]; k++) {
        double *part = vtkhdf_read_block(s, name, (int[3]){0, 0, k}, m);
        if (!part) {
            memory_free(value);
            return NULL;
        }
        for (size_t i = 0; i < plane; i++) value[(size_t)k * plane + i] = (float)part[i];
        free(part);
    }
    return value;
}

struct postproc_flow *postproc_flow_new(const struct postproc_history *h, int k) {
    struct vtkhdf_source *source = postproc_history_open(h, &h->fluid, h->fluid.entry[k].time);
    if (!source) return NULL;
    struct postproc_flow *f = NULL;
    if (source->image && source->points > 0 && vtkhdf_read_comps(source, "velocity") == 3) {
        f = memory_new(MEMORY_OUTPUT, 1, sizeof *f);
        f->time = source->time;
        f->step = source->step;
        for (int c = 0; c < 3; c++) {
            f->n[c] = source->n[c];
            f->d[c] = source->spacing[c];
        }
        f->u = (float(*)[3])(void *)floats(source, "velocity", 3);
        if (vtkhdf_read_comps(source, "solid_fraction") == 1) f->solid = floats(source, "solid_fraction", 1);
        if (f->u) {
            postproc_flow_sides(f, h->scene);
            measure(f);
        } else {
            postproc_flow_free(f);
            f = NULL;
        }
    }
    vtkhdf_read_close(source);
    return f;
}

void postproc_flow_free(struct postproc_flow *f) {
    if (!f) return;
    MEMORY_FREE(f->u, f->solid, f);
}

/* A corner of the interpolation: the cell that holds its value, and the side it was mirrored at. */
struct corner {
    int i, side; /* side: -1 for none */
};

static struct corner corner_of(const struct postproc_flow *f, int c, int i) {
    if (i >= 0 && i < f->n[c]) return (struct corner){i, -1};
    const int side = i >= 0;
    switch (f->beyond[c][side]) {
    case POSTPROC_BEYOND_WRAP:
        return (struct corner){i < 0 ? f->n[c] - 1 : 0, -1};
    case POSTPROC_BEYOND_MIRROR:
        return (struct corner){side ? f->n[c] - 1 : 0, side};
    case POSTPROC_BEYOND_COPY:
        break;
    }
    return (struct corner){side ? f->n[c] - 1 : 0, -1};
}

int postproc_flow_at(const struct postproc_flow *f, const double x[3], double u[3]) {
    struct corner at[3][2];
    double part[3], solid = 0;
    for (int c = 0; c < 3; c++) {
        double q = x[c] / f->d[c];
        if (f->beyond[c][0] == POSTPROC_BEYOND_WRAP) q -= f->n[c] * floor(q / f->n[c]);
        if (!(q >= 0 && q <= f->n[c])) return 0;
        const double low = floor(q - 0.5);
        part[c] = q - 0.5 - low;
        for (int s = 0; s < 2; s++) at[c][s] = corner_of(f, c, (int)low + s);
    }
    u[0] = u[1] = u[2] = 0;
    for (int k = 0; k < 8; k++) {
        const int s[3] = {k & 1, k >> 1 & 1, k >> 2};
        double weight = 1;
        for (int c = 0; c < 3; c++) weight *= s[c] ? part[c] : 1 - part[c];
        const size_t cell =
            ((size_t)at[2][s[2]].i * (size_t)f->n[1] + (size_t)at[1][s[1]].i) * (size_t)f->n[0] + (size_t)at[0][s[0]].i;
        for (int a = 0; a < 3; a++) {
            double value = f->u[cell][a];
            for (int c = 0; c < 3; c++)
                if (at[c][s[c]].side >= 0) value = 2 * f->wall[c][at[c][s[c]].side][a] - value;
            u[a] += weight * value;
        }
        if (f->solid) solid += weight * (double)f->solid[cell];
    }
    return solid < 0.5;
}
