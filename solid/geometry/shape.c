/* Table of the shapes. */
#include "solid/geometry/shape.h"
#include "base/ensure.h"

#include <assert.h>
#include <stddef.h>

static const struct solid_shape_kind points = {.name = "points", .places = SOLID_PLACES_POINTS},
                                     polygon = {.name = "polygon", .places = SOLID_PLACES_CELLS};

static const struct solid_shape_kind *const kind[] = {[SOLID_BOX] = &solid_shape_box,
                                                      [SOLID_SPHERE] = &solid_shape_sphere,
                                                      [SOLID_CYLINDER] = &solid_shape_cylinder,
                                                      [SOLID_POINTS] = &points,
                                                      [SOLID_POLYGON] = &polygon};
static_assert(sizeof kind / sizeof *kind == SOLID_SHAPES, "every enum solid_shape needs its line");

const struct solid_shape_kind *solid_shape_of(const struct solid_body *b) {
    ENSURE((unsigned)b->shape < SOLID_SHAPES && kind[b->shape], "shape %d", (int)b->shape);
    return kind[b->shape];
}

int solid_shape_is_on_lattice(const struct solid_body *b) { return solid_shape_of(b)->places == SOLID_PLACES_LATTICE; }
