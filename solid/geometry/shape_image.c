/* The shape of an image: its bounds. Its voxels say which sites are inside (solid/body/sites_image.h). */
#include "solid/geometry/shape.h"

#include <string.h>

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    memcpy(low, body->low, sizeof body->low);
    memcpy(high, body->high, sizeof body->high);
}

static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    (void)body;
    (void)piece;
    return 0;
}

const struct solid_shape_kind solid_shape_image = {
    .name = "image", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
