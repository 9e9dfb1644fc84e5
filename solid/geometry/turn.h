/* Rotations of boxes, cylinders, ellipsoids and regions (struct solid_turn): vectors and points into their own
 * directions and back. */
#pragma once
#include "solid/input.h"

/* The components of v along the edges; and the vector with these components. */
static inline void solid_turn_into(const struct solid_turn *turn, const double v[3], double own[3]) {
    for (int k = 0; k < 3; k++) own[k] = v[0] * turn->edge[k][0] + v[1] * turn->edge[k][1] + v[2] * turn->edge[k][2];
}
static inline void solid_turn_out(const struct solid_turn *turn, const double own[3], double v[3]) {
    for (int c = 0; c < 3; c++)
        v[c] = own[0] * turn->edge[0][c] + own[1] * turn->edge[1][c] + own[2] * turn->edge[2][c];
}

/* The place in the unturned body, or region, of the point that is at x. */
static inline void solid_turn_place_into(const struct solid_turn *turn, const double x[3], double own[3]) {
    double v[3];
    for (int c = 0; c < 3; c++) own[c] = x[c];
    if (!turn->is_turned) return;
    for (int c = 0; c < 3; c++) v[c] = x[c] - turn->about[c];
    solid_turn_into(turn, v, own);
    for (int c = 0; c < 3; c++) own[c] += turn->about[c];
}
/* Where the unturned point goes to. */
static inline void solid_turn_place_out(const struct solid_turn *turn, const double own[3], double x[3]) {
    double v[3];
    for (int c = 0; c < 3; c++) x[c] = own[c];
    if (!turn->is_turned) return;
    for (int c = 0; c < 3; c++) v[c] = own[c] - turn->about[c];
    solid_turn_out(turn, v, x);
    for (int c = 0; c < 3; c++) x[c] += turn->about[c];
}
