/* Adaptive dynamic relaxation. */
#pragma once
#include "solid/state.h"

/* Adaptive dynamic relaxation to static equilibrium under the present load: steps taken, or -1 if not converged to
 * |residual| <= tolerance * |load|. Breakage off. Collective. */
int solid_relax(struct solid *s, double tolerance, int max_steps);
