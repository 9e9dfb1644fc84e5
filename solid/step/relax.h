/* Adaptive dynamic relaxation. */
#pragma once
#include "solid/state.h"

/* Relaxes to static equilibrium under the present load. Returns the number of steps, or -1 if it has not converged to
 * |residual| <= tolerance * |load|. No bond breaks. Collective. */
int solid_relax(struct solid *s, double tolerance, int max_steps);
/* The same of a solid that is strained already, to |residual| <= tolerance * the largest of load, reaction and least,
 * N. */
int solid_relax_strained(struct solid *s, double tolerance, double least, int max_steps);
