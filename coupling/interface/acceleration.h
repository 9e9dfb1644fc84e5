/* The time over which the surface's acceleration is taken. */
#pragma once
#include "coupling/run.h"

/* Time between the two velocities whose difference makes the markers' acceleration, s: the last step's length; in the
 * strong scheme, whose velocities are means, from the middle of the last step to that of the present one. Not
 * collective. */
double acceleration_time(const struct run *r);
