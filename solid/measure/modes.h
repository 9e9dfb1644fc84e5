/* Azimuthal modes of a field on the particles, in rings about an axis: how much of a pattern has two, three, four
 * arms. In a ring the field is
 *
 *     f = f_0 + sum over k >= 1 of A_k cos(k (theta - theta_k)),   f_0 the mean by volume,
 *     A_k exp(i k theta_k) = 2/V sum of (f - f_0) exp(i k theta) V_h
 *
 * theta is taken about the axis from the first of two directions across it; places are initial ones (X0). The mean is
 * taken off first, so that a uniform field has no modes though the particles of a ring may have some. */
#pragma once
#include "solid/state.h"

enum { SOLID_MODES_MAX = 64 };

struct solid_rings {
    int rings, highest;   /* k = 1 ... highest */
    const double *radius; /* [rings + 1] m, ascending: a ring is radius[q] <= r < radius[q + 1]; borrowed */
    double centre[3];     /* m, a point of the axis */
    double across[2][3];  /* unit vectors at right angles to the axis: theta is 0 and 90 degrees there */
};
struct solid_mode {
    double amplitude, angle; /* A_k; theta_k, degrees, of the largest value nearest to 0. k = 0: f_0, 0 */
};

/* Sets the directions across an axis, which need not be of length 1: the first is the coordinate axis after that along
 * which the axis has its largest component, less its part along the axis. So z has x and y, and y has z and x. */
void solid_modes_across(const double axis[3], double across[2][3]);
/* particles [rings], mode [rings][highest + 1]; a ring without particles has NaN. field [n]. Collective. */
void solid_modes_measure(const struct solid *s, const struct solid_rings *in, const double *field, long *particles,
                         struct solid_mode *mode);
