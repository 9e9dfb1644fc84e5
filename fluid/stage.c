/* The part of a step over which the pressure and the driving of a stage act. */
#include "fluid/internal.h"

/* Before the first step no pressure is known that could stand for this step's. */
static int is_whole(const struct fluid *f) { return f->in.projection == FLUID_LAST_STAGE && f->state.t > 0; }

double fluid_stage_share(const struct fluid *f, int r) {
    return is_whole(f) ? (r == f->scheme.stages - 1 ? 1 : 0) : f->scheme.gamma[r];
}

/* A bulk velocity that is held once a step is held by a driving over the whole of it. */
double fluid_stage_share_driven(const struct fluid *f, int r) {
    return f->in.driving.type == FLUID_DRIVING_BULK ? fluid_stage_share(f, r) : f->scheme.gamma[r];
}
