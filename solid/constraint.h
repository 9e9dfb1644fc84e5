/* Held and driven layers, unbreakable regions.  (001: sec. 3.3.8) */
#pragma once
#include "solid/solid.h"

/* Flags of the owned particles from the regions, and the imposed velocities. Not collective. */
void solid_constraint_mark(struct solid *s);
/* v of held and driven directions as imposed. Not collective. */
void solid_constraint_velocity(struct solid *s);
/* a = 0 where the velocity is imposed; power_constraint = what the reaction puts in. Returns the sum of the squared
 * reactions, N2. Not collective. */
double solid_constraint_apply(struct solid *s);
double solid_density(const struct solid *s, int h); /* kg/m3 */
