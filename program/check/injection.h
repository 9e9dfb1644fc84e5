/* The regime of an injection into cracks, and what it cannot compute. */
#pragma once
#include "coupling/run.h"

/* Says a sentence for each of these, if the scene has it: a tip so fast that inertia counts, a net pressure that breaks
 * the notch's faces, a confining stress as a load, a lag that the spacing does not resolve. Not collective. */
void check_injection_warn(const struct run *r, void (*report)(const char *sentence));
/* Prints the regime of the injection, and these as warnings. Prints nothing without crack_fluid. Not collective: rank 0
 * prints. */
void check_injection_print(const struct run *r);
