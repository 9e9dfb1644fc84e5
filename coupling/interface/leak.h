/* How much fluid passes through a porous body's walls, and the slip time that keeps it small. */
#pragma once
#include "coupling/medium/medium.h"
#include "fluid/fluid.h"

/* The longest slip time of the forcing, s, with which the walls of the medium let through about a hundredth of what
 * passes through its pores. The particles are deposited. INFINITY where the fluid can go around the medium's box, or
 * the solid is not connected from its front to its back. Collective. */
double leak_slip_time(struct medium *m, const struct fluid *fluid, double immersed_area);
