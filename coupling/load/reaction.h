/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
#pragma once

#include "coupling/load/load.h"

struct reaction; /* opaque: r->reaction */

extern const struct load_kind reaction_kind;

/* Power on the solid of what the inner fluid gives back, mean over the last step, W. Collective. */
double reaction_inner_power(const struct run *r);
