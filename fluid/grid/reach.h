/* Which ghosts of this rank a reader of a box of cells can see. */
#pragma once
#include "base/par_halo.h"
#include "fluid/grid/grid.h"

/* The part of the nearest `layers` ghosts that lies in the global cells low .. high-1 or their periodic images: bounds
 * in local cells (low >= high: none) and sides. Where the box reaches beyond a side, the cells whose images stand there
 * are in the part as well. The same box on every rank gives parts that fit together. Not collective. */
struct par_halo_part fluid_reach(const struct fluid_grid *g, int layers, const int low[3], const int high[3]);
