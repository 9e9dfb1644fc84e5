/* Cylinder along x, y or z. A place on its low end is in it, one on its high end is not. */
#include "solid/geometry/shape.h"

static int contains(const struct solid_body *body, const double x[3], double tiny) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double r = x[c] - body->centre[c];
        if (c == body->axis) {
            if (r < -body->length / 2 - tiny || r >= body->length / 2 - tiny) return 0;
        } else {
            r2 += r * r;
        }
    }
    return r2 < body->radius * body->radius;
}

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
    .name = "cylinder", .places = SOLID_PLACES_LATTICE, .contains = contains, .bounds = bounds, .pieces = pieces};
