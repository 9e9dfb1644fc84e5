/* Marches rays through voxels. */
#include "postproc/draw/ray.h"

#include <math.h>

void postproc_ray_cast(struct postproc_ray *ray, const double direction[3], double length) {
    double next[3], pace[3]; /* distance to the next cell wall of each direction, and distance between two walls */
    signed char at[3] = {0, 0, 0}, sign[3];
    for (int c = 0; c < 3; c++) {
        const double d = fabs(direction[c]);
        sign[c] = direction[c] < 0 ? -1 : 1;
        pace[c] = d > 1e-12 ? 1 / d : INFINITY;
        next[c] = 0.5 * pace[c];
    }
    ray->cells = 0;
    while (ray->cells < POSTPROC_RAY_CELLS) {
        const int c = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        if (next[c] > length || at[c] * sign[c] >= 126) break;
        at[c] = (signed char)(at[c] + sign[c]);
        for (int k = 0; k < 3; k++) ray->step[ray->cells][k] = at[k];
        ray->distance[ray->cells++] = (float)next[c];
        next[c] += pace[c];
    }
}

double postproc_ray_hit(const struct postproc_ray *ray, const struct postproc_voxels *v, const int cell[3]) {
    for (int i = 0; i < ray->cells; i++) {
        const signed char *s = ray->step[i];
        const int a = cell[0] + s[0], b = cell[1] + s[1], c = cell[2] + s[2];
        if (a < 0 || b < 0 || c < 0 || a >= v->n[0] || b >= v->n[1] || c >= v->n[2]) {
            /* outside: stops unless the ray can still enter the box */
            if ((a < 0 && s[0] <= 0) || (b < 0 && s[1] <= 0) || (c < 0 && s[2] <= 0) || (a >= v->n[0] && s[0] >= 0) ||
                (b >= v->n[1] && s[1] >= 0) || (c >= v->n[2] && s[2] >= 0))
                return -1;
            continue;
        }
        if (postproc_voxels_at(v, a, b, c) >= 0) return ray->distance[i];
    }
    return -1;
}
