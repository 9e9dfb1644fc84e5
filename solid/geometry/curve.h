/* The order of the particles' numbers: along the Hilbert curve, so that near particles have near ids.  (001:
 * sec. 4.4) */
#pragma once
#include <stdint.h>

enum { SOLID_CURVE_BITS = 20 }; /* bits of a coordinate */

/* Position along the curve, in 2 or 3 dimensions, of a brick with coordinates 0 .. 2^SOLID_CURVE_BITS - 1. */
uint64_t solid_curve_key(const uint32_t *brick, int dim);
