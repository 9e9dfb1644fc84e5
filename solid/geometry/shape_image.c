/* The shape of an image: the box of its voxels, which say what is inside (solid/body/sites_image.h). */
#include "solid/geometry/shape.h"

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    solid_shape_box.bounds(body, low, high);
}

static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    return solid_shape_box.pieces(body, piece);
}

const struct solid_shape_kind solid_shape_image = {
    .name = "image", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
