/* Pressure and porosity averaged over cross sections along the axis of the stream. */
#include "postproc/data/profile.h"
#include "base/arena.h"

#include <math.h>
#include <stdlib.h>

void postproc_profile_means(const int n[3], int axis, const double *pressure, const double *solid, double *mean,
                            double *fluid, double *porosity) {
    const long stride = axis == 0 ? 1 : axis == 1 ? n[0] : (long)n[0] * n[1]; /* of cells along the axis */
    const long section = (long)n[0] * n[1] * n[2] / n[axis];
    for (int i = 0; i < n[axis]; i++) {
        double sum = 0, weighted = 0, weight = 0;
        for (long s = 0; s < section; s++) {
            const long at = s / stride * stride * n[axis] + i * stride + s % stride;
            const double p = pressure[at], w = solid ? fmin(fmax(1 - solid[at], 0), 1) : 1;
            sum += p;
            weighted += w * p;
            weight += w;
        }
        mean[i] = sum / (double)section;
        if (!solid) continue;
        fluid[i] = weight > 0 ? weighted / weight : NAN;
        porosity[i] = weight / (double)section;
    }
}

struct postproc_profile postproc_profile_new(const struct postproc_history *h, double t) {
    struct postproc_profile p = {0};
    const int axis = postproc_history_axis(h);
    struct vtkhdf_source *source = postproc_history_open(h, &h->fluid, t);
    if (!source) return p;
    double *pressure = vtkhdf_read_double(source, "pressure"), *solid = vtkhdf_read_double(source, "solid_fraction");
    if (pressure && source->image) {
        p.n = source->n[axis];
        p.time = source->time;
        p.x = arena_new((size_t)p.n, sizeof(double));
        p.pressure = arena_new((size_t)p.n, sizeof(double));
        p.fluid = solid ? arena_new((size_t)p.n, sizeof(double)) : NULL;
        p.porosity = solid ? arena_new((size_t)p.n, sizeof(double)) : NULL;
        for (int i = 0; i < p.n; i++) p.x[i] = source->origin[axis] + i * source->spacing[axis];
        postproc_profile_means(source->n, axis, pressure, solid, p.pressure, p.fluid, p.porosity);
    }
    free(pressure);
    free(solid);
    vtkhdf_read_close(source);
    return p;
}
