/* Table of the shapes; a shape without a line does not compile. */
#include "solid/geometry/shape.h"
#include "base/ensure.h"
#include "solid/geometry/on_surface.h"

#include <math.h>

static const struct solid_shape_kind points = {.name = "points", .places = SOLID_PLACES_POINTS},
                                     polygon = {.name = "polygon", .places = SOLID_PLACES_CELLS};

const struct solid_shape_kind *solid_shape_of(const struct solid_body *body) {
    switch (body->shape) {
#define RETURN_SHAPE(constant, word, keys)                                                                             \
    case SOLID_##constant:                                                                                             \
        return &solid_shape_##word;
        SOLID_LATTICE_SHAPES(RETURN_SHAPE)
    case SOLID_IMAGE:
        return &solid_shape_image;
    case SOLID_POINTS:
        return &points;
    case SOLID_POLYGON:
    case SOLID_RECTANGLE:
    case SOLID_DISC:
        return &polygon;
    }
    ENSURE(0, "shape %d", (int)body->shape);
}

int solid_shape_is_on_lattice(const struct solid_body *b) { return solid_shape_of(b)->places == SOLID_PLACES_LATTICE; }

struct solid_shape_surface solid_shape_cavities(const struct solid_body *body) {
    struct solid_shape_surface surface = {.period = body->cavity_period};
    if (surface.period > 0)
        surface.cavity = solid_piece_round(SOLID_PIECE_ALL, -1, body->cavity_centre, body->cavity_radius);
    return surface;
}

struct solid_shape_surface solid_shape_surface(const struct solid_body *body) {
    struct solid_shape_surface surface = solid_shape_cavities(body);
    surface.n = solid_shape_of(body)->pieces(body, surface.piece);
    ENSURE(surface.n <= SOLID_PIECES_MAX, "a surface of %d pieces", surface.n);
    return surface;
}

struct solid_piece solid_shape_cavity(const struct solid_shape_surface *surface, const double x[3]) {
    struct solid_piece cavity = surface->cavity;
    for (int c = 0; c < 3; c++) cavity.centre[c] += rint((x[c] - cavity.centre[c]) / surface->period) * surface->period;
    return cavity;
}

double solid_shape_piece_depth(const struct solid_piece *piece, const double x[3], double spacing) {
    double normal[3];
    if (piece->least) {
        const double least = piece->least(piece, x);
        if (!solid_on_surface_is_on(least, spacing)) return least;
    }
    return piece->depth(piece, x, normal);
}
