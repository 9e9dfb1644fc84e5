/* Where a particle stands in the fluid's domain. */
#include "coupling/interface/place.h"
#include "coupling/run.h"

int place_is_inside(const struct run *r, int h) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    double x[3];
    solid_position(r->solid, h, x);
    for (int c = 0; c < 3; c++)
        if (!g->periodic[c] && (x[c] < 0 || x[c] > g->length[c])) return 0;
    return 1;
}
