/* Adaptive dynamic relaxation. */
#pragma once
#include "solid/state.h"

/* What is returned instead of a number of steps: no equilibrium after max_steps, a part that nothing holds has moved
 * by more than ten lengths of the domain, or the program shall stop (s->stops). */
enum { SOLID_RELAX_TOO_LONG = -1, SOLID_RELAX_AWAY = -2, SOLID_RELAX_STOPPED = -3 };

/* Relaxes to static equilibrium under the present load, |residual| <= tolerance * |load|. Returns the number of
 * steps, or one of the above. No bond breaks. A long relaxation logs its progress every 20 s. If it is stopped, the
 * displacement reached so far stays, and another relaxation continues from it. Collective. */
int solid_relax(struct solid *s, double tolerance, int max_steps);
/* The same for a solid that is strained already. Ends at |residual| <= tolerance * the largest of |load|, |reaction|
 * and least, N, or at `part` of the first residual. */
int solid_relax_strained(struct solid *s, double tolerance, double least, double part, int max_steps);
