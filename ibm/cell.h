/* Coordinates in cells of the fluid's grid. */
#pragma once
#include "fluid/grid/grid.h"

#include <math.h>

/* A coordinate in cells, wrapped to [0, n) in a periodic direction. */
static inline double ibm_cell_wrap(const struct fluid_grid *g, int direction, double x) {
    const double n = g->n[direction];
    double s = x / g->d[direction];
    if (g->periodic[direction]) {
        s -= n * floor(s / n);
        if (s >= n) s = 0; /* s slightly below 0 rounds to n */
    }
    return s;
}
/* The cell of a coordinate in cells, -1 outside; the far end belongs to the last cell. */
static inline int ibm_cell(const struct fluid_grid *g, int direction, double s) {
    if (!(s >= 0 && s <= g->n[direction])) return -1;
    const int i = (int)s;
    return i < g->n[direction] ? i : i - 1;
}
