/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
#pragma once

#include "coupling/load/load.h"

struct reaction; /* opaque: r->reaction */

extern const struct load_kind reaction_kind;

/* How far the pressure inside a body has been from the mean that its cracks take (coupling/load/inner_pressure.c):
 * largest standard deviation since the last call, Pa. Not collective, the same on all ranks. */
double reaction_take_uneven(const struct run *r);
/* Mean couple over the last step, about the domain's centre, of what the fluid inside the bodies gets itself, N m.
 * Collective. */
void reaction_inner_couple(const struct run *r, double couple[3]);
/* Power on the solid of what the inner fluid gives back, mean over the last step, W. Collective. */
double reaction_inner_power(const struct run *r);
