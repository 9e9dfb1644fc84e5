/* Where a particle stands in the fluid's domain. */
#include "coupling/interface/place.h"

int place_is_inside(const struct fluid_grid *g, const struct solid *s, int h) {
    double x[3];
    solid_position(s, h, x);
    for (int c = 0; c < 3; c++)
        if (!g->periodic[c] && (x[c] < 0 || x[c] > g->length[c])) return 0;
    return 1;
}
