/* Depth below a ball, the side of a cylinder or a pair of planes, and the normal there. */
#include "solid/geometry/piece.h"
#include "solid/geometry/turn.h"

#include <math.h>
#include <string.h>

static double round_depth(const struct solid_piece *p, const double x[3], double normal[3]) {
    double r2 = 0, v[3];
    for (int c = 0; c < 3; c++) v[c] = x[c] - p->centre[c];
    if (p->turn) {
        const double from[3] = {v[0], v[1], v[2]};
        solid_turn_into(p->turn, from, v);
    }
    for (int c = 0; c < 3; c++) {
        normal[c] = p->mask[c] ? v[c] : 0;
        r2 += normal[c] * normal[c];
    }
    const double length = sqrt(r2);
    for (int c = 0; c < 3; c++) normal[c] *= length > 0 ? p->inside / length : 0;
    if (p->turn) {
        const double own[3] = {normal[0], normal[1], normal[2]};
        solid_turn_out(p->turn, own, normal);
    }
    return p->inside * (p->radius - length);
}

/* One of the two curvatures is 1/radius for the side of a cylinder, both for a ball. */
static double round_curvature(const struct solid_piece *p, const double n[3]) {
    (void)n;
    return p->inside * (p->mask[0] + p->mask[1] + p->mask[2] - 1) / (2 * p->radius);
}

struct solid_piece solid_piece_round(int mask, int inside, const double centre[3], double radius) {
    struct solid_piece p = {.depth = round_depth,
                            .curvature = round_curvature,
                            .mask = {mask & 1, mask >> 1 & 1, mask >> 2 & 1},
                            .inside = inside,
                            .radius = radius};
    memcpy(p.centre, centre, sizeof p.centre);
    return p;
}

void solid_piece_turn(struct solid_piece *piece, const struct solid_turn *turn) {
    if (!turn->is_turned) return;
    const double centre[3] = {piece->centre[0], piece->centre[1], piece->centre[2]};
    solid_turn_place_out(turn, centre, piece->centre);
    piece->turn = turn;
}
