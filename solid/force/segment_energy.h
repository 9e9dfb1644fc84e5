/* Elastic energy of the bonds of one segment of a lattice, each bond once. For solid/ only. */
#pragma once
#include "solid/force/segment.h"

struct solid_segment_energy {
    double whole, half; /* of bonds between particles owned here, and of bonds to ghosts and images; m2/s2 */
    double largest;     /* |eps| of these bonds */
};

/* Pure. The sum of stiffness times |xi|^2 s^2, stiffness = alpha c0 Gamma V/(rho |xi|) as in the force sweep; times
 * rho V/2 it is the energy, J. Half of the energy of a bond to a ghost or image belongs to its other end. in: d, w,
 * offset, and with KERNEL_SEVERAL half. kernel: bits BULK, EXACT and SEVERAL. Without EXACT s^2 is a series, good to
 * 1e-15 for |eps| up to 1/256. */
struct solid_segment_energy solid_segment_energy(const struct solid_boxes *in, const struct solid_segments *segments,
                                                 int g, enum solid_kernel kernel);
