/* Where a particle stands in the fluid's domain. */
#pragma once
#include "fluid/fluid.h"
#include "solid/state.h"

/* Whether particle h stands in the domain. Not collective. */
int place_is_inside(const struct fluid_grid *g, const struct solid *s, int h);
