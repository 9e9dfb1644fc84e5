/* What a run holds and leaves out. */
#pragma once
#include "coupling/run.h"

/* Prints it, with warnings on lattice points on surfaces, particles that are too near and bodies outside the domain.
 * Collective. */
void check_holdings_print(struct run *r);
