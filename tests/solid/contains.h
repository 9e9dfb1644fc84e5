/* Whether a point belongs to a body, for tests that ask point by point. */
#pragma once
#include "solid/geometry/compound.h"
#include "solid/geometry/on_surface.h"

/* In the body's shape or on its surface, and inside none of its cavities. */
static inline int contains(const struct solid_body *body, const double x[3], double spacing) {
    const struct solid_input in = {.spacing = spacing};
    struct solid_compound *compound = solid_compound_new(&in, body);
    const double depth = solid_compound_depth(compound, x);
    solid_compound_free(compound);
    return solid_on_surface_is_inside(depth, spacing);
}
