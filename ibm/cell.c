/* Coordinates in cells, across periodic sides. */
#include "ibm/cell.h"

#include <math.h>

double ibm_cell_wrap(const struct fluid_grid *g, int direction, double x) {
    const double n = g->n[direction];
    double s = x / g->d[direction];
    if (g->periodic[direction]) {
        s -= n * floor(s / n);
        if (s >= n) s = 0; /* s slightly below 0 rounds to n */
    }
    return s;
}
