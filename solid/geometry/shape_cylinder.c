/* Cylinder along x, y or z, or turned. */
#include "solid/geometry/shape.h"
#include "solid/geometry/turn.h"

#include <math.h>

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    double centre[3];
    solid_turn_place_out(&body->turn, body->centre, centre);
    for (int c = 0; c < 3; c++) {
        const double along = body->turn.edge[body->axis][c];
        double half = c == body->axis ? body->length / 2 : body->radius;
        if (body->turn.is_turned)
            half = fabs(along) * (body->length / 2) + body->radius * sqrt(fmax(1 - along * along, 0));
        low[c] = centre[c] - half;
        high[c] = centre[c] + half;
    }
}

/* Its side, and its two ends. */
static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    piece[0] = solid_piece_round(SOLID_PIECE_ALL & ~(1 << body->axis), 1, body->centre, body->radius);
    piece[1] = solid_piece_round(1 << body->axis, 1, body->centre, body->length / 2);
    for (int k = 0; k < 2; k++) solid_piece_turn(&piece[k], &body->turn);
    return 2;
}

const struct solid_shape_kind solid_shape_cylinder = {
    .name = "cylinder", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
