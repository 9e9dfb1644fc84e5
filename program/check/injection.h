/* What a scene with crack_fluid can and cannot compute, in numbers. */
#pragma once
#include "coupling/run.h"

/* Prints the regime of the injection, and a warning for each of these that the scene has: a notch through a row of
 * particles, a tip that runs with inertia, a net pressure that breaks the notch's faces, a confining stress, a lag that
 * the spacing does not resolve. Prints nothing without crack_fluid. Collective. */
void check_injection_print(const struct run *r);
