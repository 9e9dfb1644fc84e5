/* Box with faces along x, y and z, or turned. */
#include "solid/geometry/shape.h"
#include "solid/geometry/turn.h"

#include <math.h>
#include <string.h>

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    double centre[3];
    if (!body->turn.is_turned) {
        memcpy(low, body->low, sizeof body->low);
        memcpy(high, body->high, sizeof body->high);
        return;
    }
    for (int c = 0; c < 3; c++) centre[c] = (body->low[c] + body->high[c]) / 2;
    solid_turn_place_out(&body->turn, centre, low);
    memcpy(high, low, sizeof centre);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            const double half = fabs(body->turn.edge[k][c]) * ((body->high[k] - body->low[k]) / 2);
            low[c] -= half;
            high[c] += half;
        }
}

/* Three pairs of planes. */
static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    for (int c = 0; c < 3; c++) {
        double centre[3] = {0};
        for (int d = 0; d < 3; d++)
            if (d == c || body->turn.is_turned) centre[d] = (body->low[d] + body->high[d]) / 2;
        piece[c] = solid_piece_round(1 << c, 1, centre, (body->high[c] - body->low[c]) / 2);
        solid_piece_turn(&piece[c], &body->turn);
    }
    return 3;
}

const struct solid_shape_kind solid_shape_box = {
    .name = "box", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
