/* The shapes that bodies are cut from: one file a shape, one line in the table. */
#pragma once
#include "solid/geometry/piece.h"

/* Where a body's particles stand. */
enum solid_places {
    SOLID_PLACES_LATTICE, /* sites of the lattice inside the shape */
    SOLID_PLACES_CELLS,   /* cells of a plate's lattice inside the outlines (solid/geometry/outline.h) */
    SOLID_PLACES_POINTS   /* the given points, on no lattice */
};

struct solid_shape_kind {
    const char *name;
    enum solid_places places;
    /* of a shape on the lattice; tiny: places nearer to a face than this are on it, m */
    int (*contains)(const struct solid_body *body, const double x[3], double tiny);
    void (*bounds)(const struct solid_body *body, double low[3], double high[3]); /* m */
    /* its surface as smooth pieces; returns how many */
    int (*pieces)(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]);
};

extern const struct solid_shape_kind solid_shape_box, solid_shape_sphere, solid_shape_cylinder, solid_shape_ellipsoid;

const struct solid_shape_kind *solid_shape_of(const struct solid_body *body); /* Not collective. */
/* The same, of a body whose particles stand on the lattice: shapes that have bounds, a surface, and may have cavities.
 */
int solid_shape_is_on_lattice(const struct solid_body *body);
