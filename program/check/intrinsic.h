/* frana check: what the intrinsic permeability of a run will cost. */
#pragma once
#include "coupling/run.h"

/* Prints samples, solutions, memory and time, and warns where that is much of the run's time. seconds: of the run
 * without it, 0: not known; measured: the first sample is taken here. Nothing without output.permeability_every.
 * Collective. */
void check_intrinsic_print(struct run *r, double seconds, int measured);
/* Prints what frana permeability would take of so many pore cells: on the scene's grid, and on one twice as fine. */
void check_intrinsic_print_at_once(double pores, const char *others);
/* The same of a run whose solid is rigid, by the particles' volume. Collective. */
void check_intrinsic_print_rigid(const struct run *r);
