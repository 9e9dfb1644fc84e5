/* Finds the smooth piece of a shape's surface or of a cavity next to a particle: depth and normal. */
#include "solid/surface/piece.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/shape.h"
#include "solid/surface/sector.h"

int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece) {
    if (!solid_shape_is_on_lattice(body)) return 0;
    const struct solid_shape_surface surface = solid_shape_surface(body);
    for (int k = 0; k < surface.n + (surface.period > 0); k++) {
        const struct solid_piece at = k < surface.n ? surface.piece[k] : solid_shape_cavity(&surface, x);
        double e[3], beyond[3], normal[3];
        unsigned bounded = 0;
        for (int f = 0; f < SOLID_FACES; f++) {
            solid_sector_axis(f, e);
            for (int c = 0; c < 3; c++) beyond[c] = x[c] + spacing * e[c];
            if (!solid_on_surface_is_inside(at.depth(&at, beyond, normal), spacing)) bounded |= 1u << f;
        }
        if (!open || (open & ~bounded)) continue;
        *piece = at;
        return 1;
    }
    return 0;
}
