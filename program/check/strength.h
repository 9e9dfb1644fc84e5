/* frana check: whether a load can break anything. */
#pragma once
#include "coupling/run.h"

/* For each body, or bodies that interfaces join: the stress that its loads and prescribed motions will about make, the
 * stress at which it breaks, and the factor between them. seconds: of the run, as far as they are known. Nothing in a
 * run in which bonds do not break. Rank 0 prints. Collective. */
void check_strength_print(struct run *r, double seconds);
