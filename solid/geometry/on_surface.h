/* Points on a surface: the one rule and the one tolerance by which bodies, cavities, holes, regions and initial cracks
 * are cut from the lattice (docs/design/solid.md, Points on a surface). A point nearer to a surface than the tolerance
 * lies on it, and what lies on it is inside: on the surface of a shape, a cavity or a hole it is in the body, on the
 * border of a region it is in the region, on an initial crack it is cut. The tolerance is far above the round-off of
 * coordinates (some 1e-11 spacings at 10^5 spacings from the origin), so that scale, place and compiler change nothing.
 */
#pragma once

/* In spacings, 4.8e-7: half the unit to which a plate's positions are rounded (solid/body/cloud.h). */
#define SOLID_ON_SURFACE 0x1p-21

/* depth: distance from the surface, > 0 inside, in the spacing's unit. */
static inline int solid_on_surface_is_inside(double depth, double spacing) {
    return depth >= -SOLID_ON_SURFACE * spacing;
}

static inline int solid_on_surface_is_on(double depth, double spacing) {
    return depth >= -SOLID_ON_SURFACE * spacing && depth <= SOLID_ON_SURFACE * spacing;
}

/* Depth of x below the faces of a box in dim directions: the distance from the nearest face, at least inside. */
static inline double solid_on_surface_depth(const double x[], const double low[], const double high[], int dim) {
    double depth = __builtin_inf();
    for (int c = 0; c < dim; c++) {
        depth = x[c] - low[c] < depth ? x[c] - low[c] : depth;
        depth = high[c] - x[c] < depth ? high[c] - x[c] : depth;
    }
    return depth;
}
