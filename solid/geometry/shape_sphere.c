/* Sphere. */
#include "solid/geometry/shape.h"

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) {
        low[c] = body->centre[c] - body->radius;
        high[c] = body->centre[c] + body->radius;
    }
}

static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    piece[0] = solid_piece_round(SOLID_PIECE_ALL, 1, body->centre, body->radius);
    return 1;
}

const struct solid_shape_kind solid_shape_sphere = {
    .name = "sphere", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
