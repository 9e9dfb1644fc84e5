/* Table of the shapes; a shape without a line does not compile. */
#include "solid/geometry/shape.h"
#include "base/ensure.h"

static const struct solid_shape_kind points = {.name = "points", .places = SOLID_PLACES_POINTS},
                                     polygon = {.name = "polygon", .places = SOLID_PLACES_CELLS};

const struct solid_shape_kind *solid_shape_of(const struct solid_body *body) {
    switch (body->shape) {
    case SOLID_BOX:
        return &solid_shape_box;
    case SOLID_SPHERE:
        return &solid_shape_sphere;
    case SOLID_CYLINDER:
        return &solid_shape_cylinder;
    case SOLID_ELLIPSOID:
        return &solid_shape_ellipsoid;
    case SOLID_POINTS:
        return &points;
    case SOLID_POLYGON:
        return &polygon;
    case SOLID_SHAPES:
        break;
    }
    ENSURE(0, "shape %d", (int)body->shape);
}

int solid_shape_is_on_lattice(const struct solid_body *b) { return solid_shape_of(b)->places == SOLID_PLACES_LATTICE; }
