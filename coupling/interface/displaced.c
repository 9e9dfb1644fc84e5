/* Momentum, mass and kinetic energy of the fluid that the solid displaces. */
#include "coupling/interface/displaced.h"
#include "coupling/interface/place.h"
#include "coupling/run.h"

struct displaced displaced_by_solid(const struct run *r) {
    const struct solid *s = r->solid;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double density = fluid_input_of(r->fluid)->density;
    struct displaced d = {.mass = 0};
    for (int h = 0; h < s->n; h++) {
        if (!place_is_inside(g, s, h)) continue;
        const double mass = density * s->volume[h];
        d.mass += mass;
        for (int c = 0; c < s->dim; c++) {
            d.momentum[c] += mass * s->v[c][h];
            d.kinetic += 0.5 * mass * s->v[c][h] * s->v[c][h];
        }
    }
    return d;
}
