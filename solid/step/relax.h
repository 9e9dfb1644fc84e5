/* Adaptive dynamic relaxation. */
#pragma once
#include "solid/state.h"

/* Relaxes to static equilibrium under the present load. Returns the number of steps, or -1 if it has not converged to
 * |residual| <= tolerance * |load|. No bond breaks. Collective. */
int solid_relax(struct solid *s, double tolerance, int max_steps);
