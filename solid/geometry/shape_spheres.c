/* List of spheres and ellipsoids. */
#include "solid/geometry/shape.h"

#include <math.h>
#include <string.h>

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) {
        low[c] = INFINITY;
        high[c] = -INFINITY;
        for (long k = 0; k < body->entries; k++) {
            low[c] = fmin(low[c], body->entry[k][c] - body->entry[k][3 + c]);
            high[c] = fmax(high[c], body->entry[k][c] + body->entry[k][3 + c]);
        }
    }
}

static void entry(const struct solid_body *body, long k, struct solid_body *one) {
    const double *sphere = body->entry[k];
    one->shape = sphere[3] == sphere[4] && sphere[4] == sphere[5] ? SOLID_SPHERE : SOLID_ELLIPSOID;
    memcpy(one->centre, sphere, sizeof one->centre);
    memcpy(one->radii, sphere + 3, sizeof one->radii);
    one->radius = sphere[3];
    one->turn = (struct solid_turn){0};
}

const struct solid_shape_kind solid_shape_spheres = {
    .name = "spheres", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .entry = entry};
