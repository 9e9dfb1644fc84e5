/* Pressure and porosity averaged over cross sections along x. */
#include "postproc/data/profile.h"
#include "base/arena.h"

#include <math.h>
#include <stdlib.h>

void postproc_profile_means(const int n[3], const double *pressure, const double *solid, double *mean, double *fluid,
                            double *porosity) {
    const long section = (long)n[1] * n[2];
    for (int i = 0; i < n[0]; i++) {
        double sum = 0, weighted = 0, weight = 0;
        for (long s = 0; s < section; s++) {
            const double p = pressure[s * n[0] + i], w = solid ? fmin(fmax(1 - solid[s * n[0] + i], 0), 1) : 1;
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
    struct vtkhdf_source *source = postproc_history_open(h, &h->fluid, t);
    if (!source) return p;
    double *pressure = vtkhdf_read_double(source, "pressure"), *solid = vtkhdf_read_double(source, "solid_fraction");
    if (pressure && source->image) {
        p.n = source->n[0];
        p.time = source->time;
        p.x = arena_new((size_t)p.n, sizeof(double));
        p.pressure = arena_new((size_t)p.n, sizeof(double));
        p.fluid = solid ? arena_new((size_t)p.n, sizeof(double)) : NULL;
        p.porosity = solid ? arena_new((size_t)p.n, sizeof(double)) : NULL;
        for (int i = 0; i < p.n; i++) p.x[i] = source->origin[0] + i * source->spacing[0];
        postproc_profile_means(source->n, pressure, solid, p.pressure, p.fluid, p.porosity);
    }
    free(pressure);
    free(solid);
    vtkhdf_read_close(source);
    return p;
}
