/* Depth of interface particles by the number of their neighbours in the undeformed, unbroken body (physics/depth.h). */
#pragma once
#include "solid/bonds/family.h"

/* The depth in spacings; negative where there is none: a particle on no lattice, or of a plate. Sites across periodic
 * sides and particles outside the fluid's domain count. Not collective.
 */
float solid_counted_depth(const struct solid *s, int h, const struct solid_family_view *view);
