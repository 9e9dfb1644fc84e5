/* Sorts particles into voxels. */
#include "postproc/draw/voxels.h"
#include "base/memory.h"

#include <math.h>

/* The lattice's phase in [0, 1): the mean angle of the particles' coordinates, on which a few stray particles have no
 * effect. */
static double phase(long n, const double (*x)[3], int c, double size, double low, double high) {
    double s = 0, k = 0;
    for (long i = 0; i < n; i++) {
        if (!(x[i][c] >= low && x[i][c] <= high)) continue;
        const double angle = 2 * M_PI * x[i][c] / size;
        s += sin(angle);
        k += cos(angle);
    }
    return atan2(s, k) / (2 * M_PI);
}

struct postproc_voxels *postproc_voxels_new(long n, const double (*x)[3], double size, const double low[3],
                                            const double high[3]) {
    struct postproc_voxels *v = memory_new(MEMORY_OUTPUT, 1, sizeof *v);
    v->size = size;
    double cells = 1;
    for (int c = 0; c < 3; c++) {
        double a = INFINITY, b = -INFINITY;
        for (long i = 0; i < n; i++) {
            if (!(x[i][c] >= low[c] && x[i][c] <= high[c])) continue;
            a = fmin(a, x[i][c]);
            b = fmax(b, x[i][c]);
        }
        const double corner = (phase(n, x, c, size, low[c], high[c]) - 0.5) * size;
        const double i0 = floor((a - corner) / size), i1 = floor((b - corner) / size);
        v->origin[c] = corner + i0 * size;
        cells *= i1 - i0 + 1;
        v->n[c] = a <= b && cells < 5e8 ? (int)(i1 - i0) + 1 : 0;
    }
    const size_t all = (size_t)v->n[0] * (size_t)v->n[1] * (size_t)v->n[2];
    if (all == 0) {
        memory_free(v);
        return NULL;
    }
    v->first = memory_new(MEMORY_OUTPUT, all, sizeof *v->first);
    for (size_t i = 0; i < all; i++) v->first[i] = -1;
    for (long i = 0; i < n; i++) {
        int q[3];
        if (!postproc_voxels_cell(v, x[i], q)) continue;
        v->first[((size_t)q[2] * (size_t)v->n[1] + (size_t)q[1]) * (size_t)v->n[0] + (size_t)q[0]] = (int)i;
    }
    return v;
}

void postproc_voxels_free(struct postproc_voxels *v) {
    if (!v) return;
    MEMORY_FREE(v->first, v);
}

int postproc_voxels_cell(const struct postproc_voxels *v, const double x[3], int cell[3]) {
    for (int c = 0; c < 3; c++) {
        const double q = (x[c] - v->origin[c]) / v->size;
        if (!(q >= 0 && q < v->n[c])) return 0;
        cell[c] = (int)q;
    }
    return 1;
}
