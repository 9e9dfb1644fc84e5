/* The box of a problem, once layers of given pressure are put at the ends of an axis. */
#pragma once
#include "stokes/input.h"
#include "stokes/mask.h"

struct stokes_grid {
    struct stokes_input in;
    const struct stokes_mask *mask; /* with the layers; borrowed */
    int axis;                       /* along which pressures are given: layers 0 and n - 1 are outside; else -1 */
};

/* The neighbour of a cell in a direction (0 .. 5: x low, x high, y low, ...). */
enum stokes_beyond { STOKES_BEYOND_NONE, STOKES_BEYOND_WALL, STOKES_BEYOND_SLIP };

/* Moves to the neighbour. Beyond a side that is not periodic it does not move and tells which side it is. wraps: -1 or
 * 1 where it comes in at the opposite side. */
static inline enum stokes_beyond stokes_grid_step(const struct stokes_grid *g, int at[3], int direction, int *wraps) {
    const int c = direction / 2, high = direction % 2, n = g->mask->n[c];
    *wraps = 0;
    at[c] += high ? 1 : -1;
    if (at[c] >= 0 && at[c] < n) return STOKES_BEYOND_NONE;
    if (g->in.side[c][high] == STOKES_SIDE_PERIODIC) {
        at[c] -= high ? n : -n;
        *wraps = high ? 1 : -1;
        return STOKES_BEYOND_NONE;
    }
    at[c] -= high ? 1 : -1;
    return g->in.side[c][high] == STOKES_SIDE_SLIP ? STOKES_BEYOND_SLIP : STOKES_BEYOND_WALL;
}
/* Whether a cell is in a layer of given pressure. */
static inline int stokes_grid_is_outside(const struct stokes_grid *g, const int at[3]) {
    return g->axis >= 0 && (at[g->axis] == 0 || at[g->axis] == g->mask->n[g->axis] - 1);
}
