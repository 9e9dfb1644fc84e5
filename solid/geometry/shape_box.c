/* Box with faces along x, y and z. */
#include "solid/geometry/shape.h"

#include <string.h>

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    memcpy(low, body->low, sizeof body->low);
    memcpy(high, body->high, sizeof body->high);
}

/* Three pairs of planes. */
static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    for (int c = 0; c < 3; c++) {
        double centre[3] = {0};
        centre[c] = (body->low[c] + body->high[c]) / 2;
        piece[c] = solid_piece_round(1 << c, 1, centre, (body->high[c] - body->low[c]) / 2);
    }
    return 3;
}

const struct solid_shape_kind solid_shape_box = {
    .name = "box", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
