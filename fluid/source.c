/* What drives the fluid. */
#include "fluid/internal.h"

double fluid_source(const struct fluid *f, int c) {
    return f->in.body_force[c] + fluid_driving_along(&f->in, c) * f->state.driving / f->in.density;
}
