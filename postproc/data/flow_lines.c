/* Places the seeds of a fluid's streamlines. */
#include "postproc/data/flow_lines.h"

#include <math.h>

/* The domain along the main direction, which a line does not leave also where it is periodic. */
struct between {
    int axis;
    double size;
};

static int has_left(void *with, const double x[3]) {
    const struct between *b = with;
    return x[b->axis] <= 0 || x[b->axis] >= b->size;
}

static int velocity_at(const void *field, const double x[3], double u[3]) { return postproc_flow_at(field, x, u); }

struct postproc_stream postproc_flow_lines_new(const struct postproc_flow *f, int lines) {
    struct postproc_stream s = {0};
    double size[3], least = INFINITY;
    int axis = 0, n[3];
    for (int c = 0; c < 3; c++) {
        size[c] = f->n[c] * f->d[c];
        least = fmin(least, f->d[c]);
        if (fabs(f->mean[c]) > fabs(f->mean[axis])) axis = c;
    }
    if (!(f->fastest > 0)) return s;
    const int through = fabs(f->mean[axis]) > 1e-3 * f->fastest;
    const double volume = size[0] * size[1] * size[2];
    const double spacing = through ? sqrt(volume / size[axis] / lines) : cbrt(volume / lines);
    for (int c = 0; c < 3; c++) n[c] = through && c == axis ? 1 : (int)fmax(1, fmin(rint(size[c] / spacing), f->n[c]));
    struct between b = {axis, size[axis]};
    const struct postproc_stream_input in = {.at = velocity_at,
                                             .field = f,
                                             .step = least / 4,
                                             .slowest = 1e-4 * f->fastest,
                                             .longest = 4 * (size[0] + size[1] + size[2]),
                                             .enough = through ? has_left : NULL,
                                             .with = &b};
    for (long i = 0; i < (long)n[0] * n[1] * n[2]; i++) {
        const long at[3] = {i % n[0], i / n[0] % n[1], i / n[0] / n[1]};
        double seed[3];
        for (int c = 0; c < 3; c++) seed[c] = ((double)at[c] + 0.5) * size[c] / n[c];
        if (through) seed[axis] = f->mean[axis] > 0 ? 1e-3 * f->d[axis] : size[axis] - 1e-3 * f->d[axis];
        postproc_stream_add(&s, &in, seed, !through);
    }
    return s;
}
