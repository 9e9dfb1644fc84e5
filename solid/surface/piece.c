/* Finds the smooth piece of a shape's surface or of a cavity next to a particle: depth and normal. */
#include "solid/surface/piece.h"
#include "base/ensure.h"
#include "solid/geometry/shape.h"
#include "solid/surface/sector.h"

#include <math.h>

/* The pieces of the shape, and of its cavities the one about x. */
static int pieces_of(const struct solid_body *body, const double x[3], struct solid_piece piece[SOLID_PIECES_MAX]) {
    if (!solid_shape_is_on_lattice(body)) return 0;
    double centre[3];
    int n = solid_shape_of(body)->pieces(body, piece);
    ENSURE(n + (body->cavity_period > 0) <= SOLID_PIECES_MAX, "a surface of %d pieces", n);
    if (body->cavity_period > 0) {
        for (int c = 0; c < 3; c++)
            centre[c] = body->cavity_centre[c] +
                        rint((x[c] - body->cavity_centre[c]) / body->cavity_period) * body->cavity_period;
        piece[n++] = solid_piece_round(SOLID_PIECE_ALL, -1, centre, body->cavity_radius);
    }
    return n;
}

int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece) {
    struct solid_piece all[SOLID_PIECES_MAX];
    const int n = pieces_of(body, x, all);
    for (int k = 0; k < n; k++) {
        double e[3], beyond[3], normal[3];
        unsigned bounded = 0;
        for (int f = 0; f < SOLID_FACES; f++) {
            solid_sector_axis(f, e);
            for (int c = 0; c < 3; c++) beyond[c] = x[c] + spacing * e[c];
            if (all[k].depth(&all[k], beyond, normal) < 1e-6 * spacing) bounded |= 1u << f;
        }
        if (!open || (open & ~bounded)) continue;
        *piece = all[k];
        return 1;
    }
    return 0;
}
