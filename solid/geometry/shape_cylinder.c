/* Cylinder along x, y or z. A place on its low end is in it, one on its high end is not. */
#include "solid/geometry/shape.h"

static int contains(const struct solid_body *b, const double x[3], double tiny) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        const double r = x[c] - b->centre[c];
        if (c == b->axis) {
            if (r < -b->length / 2 - tiny || r >= b->length / 2 - tiny) return 0;
        } else {
            r2 += r * r;
        }
    }
    return r2 < b->radius * b->radius;
}

static void bounds(const struct solid_body *b, double low[3], double high[3]) {
    for (int c = 0; c < 3; c++) {
        const double half = c == b->axis ? b->length / 2 : b->radius;
        low[c] = b->centre[c] - half;
        high[c] = b->centre[c] + half;
    }
}

/* Its side, and its two ends. */
static int pieces(const struct solid_body *b, struct solid_piece piece[SOLID_PIECES_MAX]) {
    piece[0] = solid_piece_round(SOLID_PIECE_ALL & ~(1 << b->axis), 1, b->centre, b->radius);
    piece[1] = solid_piece_round(1 << b->axis, 1, b->centre, b->length / 2);
    return 2;
}

const struct solid_shape_kind solid_shape_cylinder = {
    .name = "cylinder", .places = SOLID_PLACES_LATTICE, .contains = contains, .bounds = bounds, .pieces = pieces};
