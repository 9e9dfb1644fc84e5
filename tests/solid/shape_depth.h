/* Depth below all pieces of a shape, for the tests. */
#pragma once
#include "solid/geometry/shape.h"

#include <math.h>

/* Depth of x below the pieces and the cavity next to it, the least of them, m. */
static inline double shape_depth(const struct solid_shape_surface *surface, const double x[3], double spacing) {
    double depth = INFINITY;
    for (int k = 0; k < surface->n; k++) depth = fmin(depth, solid_shape_piece_depth(&surface->piece[k], x, spacing));
    if (surface->period > 0) {
        const struct solid_piece cavity = solid_shape_cavity(surface, x);
        depth = fmin(depth, solid_shape_piece_depth(&cavity, x, spacing));
    }
    return depth;
}
