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
    /* of a shape on the lattice */
    void (*bounds)(const struct solid_body *body, double low[3], double high[3]); /* m */
    /* its surface as smooth pieces; returns how many. The shape is what is below all of them. Of an image they are
     * its bounds: its voxels say what is inside. NULL: a list of shapes */
    int (*pieces)(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]);
    /* the k-th shape of a list, 0 <= k < body->entries, as a body: its shape and sizes alone; NULL: no list */
    void (*entry)(const struct solid_body *body, long k, struct solid_body *entry);
};

#define SOLID_SHAPE_DECLARE(constant, word, keys) extern const struct solid_shape_kind solid_shape_##word;
SOLID_LATTICE_SHAPES(SOLID_SHAPE_DECLARE)
extern const struct solid_shape_kind solid_shape_image;

const struct solid_shape_kind *solid_shape_of(const struct solid_body *body); /* Not collective. */
/* The same, of a body whose particles stand on the lattice: shapes that have bounds, a surface, and may have cavities.
 */
int solid_shape_is_on_lattice(const struct solid_body *body);

/* The surface of one shape: its pieces, and the array of its body's cavities. Bodies of several shapes, with holes or
 * across periodic sides: solid/geometry/compound.h. */
struct solid_shape_surface {
    int n;
    struct solid_piece piece[SOLID_PIECES_MAX];
    double period; /* of the cavities, m; 0: none */
    struct solid_piece cavity;
};

/* Nothing below is collective. */
/* The cavities alone, without pieces. */
struct solid_shape_surface solid_shape_cavities(const struct solid_body *body);
struct solid_shape_surface solid_shape_surface(const struct solid_body *body);
/* The cavity nearest to x; needs cavities. */
struct solid_piece solid_shape_cavity(const struct solid_shape_surface *surface, const double x[3]);
/* Depth of x below a piece, m. More than the tolerance of solid/geometry/on_surface.h away from the surface it may be a
 * number of the same sign that is nearer to 0. */
double solid_shape_piece_depth(const struct solid_piece *piece, const double x[3], double spacing);
