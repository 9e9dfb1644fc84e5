/* What enters the cracks through the wet particles of a box. */
#pragma once
#include "cracks/cracks.h"

/* Finds each injection's particles and their parts of it, after the struts were made anew. Collective. */
void cracks_inject_renew(struct cracks *c);
/* Dies (exit 2) on an injection without a wet particle. Collective. */
void cracks_inject_check(const struct cracks *c);
/* Adds dt Q of the rates, means over the substep, to b, and sets the pressures given at its end: p and the set of their
 * particles. Returns the sum of dt |Q|. Not collective. */
double cracks_inject_source(struct cracks *c, double t, double dt, double *b);
/* Books what has entered: adds dt Q to content; of a particle with a given pressure dt Q closes its balance. residual
 * of the solution, flow = dt L p [n]. Collective. */
void cracks_inject_fill(struct cracks *c, double dt, const double *residual, const double *flow);
