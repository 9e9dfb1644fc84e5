/* Finds the smooth piece of a shape's surface, a hole's or a cavity's next to a particle: depth and normal. */
#include "solid/surface/piece.h"
#include "solid/geometry/on_surface.h"
#include "solid/surface/sector.h"

#include <math.h>

static const double STEP = 0.01; /* spacings */

/* Whether the piece is between x and all void sites next to it. */
static int bounds_all(const struct solid_piece *piece, const double x[3], unsigned open, double spacing) {
    double e[3], beyond[3], normal[3];
    unsigned bounded = 0;
    for (int f = 0; f < SOLID_FACES; f++) {
        solid_sector_axis(f, e);
        for (int c = 0; c < 3; c++) beyond[c] = x[c] + spacing * e[c];
        if (!solid_on_surface_is_inside(piece->depth(piece, beyond, normal), spacing)) bounded |= 1u << f;
    }
    return open && !(open & ~bounded);
}

/* The depth of x below the piece; INFINITY if x is not below it, or if its nearest point is not on the body's surface:
 * in another shape or a hole, or where two shapes touch, so that a step beyond it ends in the other one. */
static double shown_depth(struct solid_compound *compound, const struct solid_piece *piece, const double x[3]) {
    double normal[3], foot[3], beyond[3];
    const double depth = piece->depth(piece, x, normal), spacing = compound->spacing;
    if (!solid_on_surface_is_inside(depth, spacing)) return INFINITY;
    for (int c = 0; c < 3; c++) {
        foot[c] = x[c] + depth * normal[c];
        beyond[c] = foot[c] + STEP * spacing * normal[c];
    }
    const int is_shown = solid_on_surface_is_on(solid_compound_depth(compound, foot), spacing) &&
                         !solid_on_surface_is_inside(solid_compound_depth(compound, beyond), spacing);
    return is_shown ? depth : INFINITY;
}

int solid_piece_of(struct solid_compound *compound, const double x[3], unsigned open, struct solid_piece *piece) {
    double nearest = INFINITY;
    int n;
    const int *near = solid_compound_near(compound, x, &n);
    for (int q = 0; q < n; q++) {
        const struct solid_compound_member *m = &compound->member[near[q]];
        struct solid_piece at;
        for (int k = 0; solid_compound_piece(compound, m, k, x, &at); k++) {
            if (!bounds_all(&at, x, open, compound->spacing)) continue;
            if (compound->members == 1) { /* the first of them, on the surface or not */
                *piece = at;
                return 1;
            }
            const double depth = shown_depth(compound, &at, x);
            if (depth >= nearest) continue;
            *piece = at;
            nearest = depth;
        }
    }
    return nearest < INFINITY;
}
