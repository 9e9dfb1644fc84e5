/* Coordinates in cells of the fluid's grid. */
#pragma once
#include "fluid/grid/grid.h"

/* Coordinate in cells: within [0, n) where periodic. */
double ibm_cell_wrap(const struct fluid_grid *g, int direction, double x);
/* The cell of a coordinate in cells, -1 outside; the far end belongs to the last cell. */
static inline int ibm_cell(const struct fluid_grid *g, int direction, double s) {
    if (!(s >= 0 && s <= g->n[direction])) return -1;
    const int i = (int)s;
    return i < g->n[direction] ? i : i - 1;
}
