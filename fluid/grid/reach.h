/* Which ghost cells of this rank lie in a given box of global cells. */
#pragma once
#include "base/par_halo.h"
#include "fluid/grid/grid.h"

/* The part of the nearest `layers` ghosts that lies in the global cells low .. high-1 or in their periodic images:
 * bounds in local cells (low >= high: none) and sides. If the box reaches beyond a side, the part also holds the cells
 * that the ghosts there are images of. The same box on every rank gives consistent parts. Not collective. */
struct par_halo_part fluid_reach(const struct fluid_grid *g, int layers, const int low[3], const int high[3]);
