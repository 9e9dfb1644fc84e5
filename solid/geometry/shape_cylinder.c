/* Cylinder along x, y or z. */
#include "solid/geometry/shape.h"

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) {
        const double half = c == body->axis ? body->length / 2 : body->radius;
        low[c] = body->centre[c] - half;
        high[c] = body->centre[c] + half;
    }
}

/* Its side, and its two ends. */
static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    piece[0] = solid_piece_round(SOLID_PIECE_ALL & ~(1 << body->axis), 1, body->centre, body->radius);
    piece[1] = solid_piece_round(1 << body->axis, 1, body->centre, body->length / 2);
    return 2;
}

const struct solid_shape_kind solid_shape_cylinder = {
    .name = "cylinder", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
