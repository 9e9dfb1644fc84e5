/* What enters the cracks through the wet particles of a box. */
#pragma once
#include "cracks/cracks.h"

/* Finds each injection's particles and their parts of it, after the struts were made again. Collective. */
void cracks_inject_renew(struct cracks *c);
/* Dies (exit 2) on an injection without a wet particle. Collective. */
void cracks_inject_check(const struct cracks *c);
/* Sets the rates, means over the substep from t on, and the pressures given at its end: p and the set of their
 * particles. Returns the sum of dt |Q| of the rates. Not collective. */
double cracks_inject_begin(struct cracks *c, double t, double dt);
/* Adds dt Q of the rates to source [n], m3. Not collective. */
void cracks_inject_source(const struct cracks *c, double dt, double *source);
/* Adds dt Q, which has entered, to the content; of a particle with a given pressure dt Q closes its balance. residual:
 * of the solution, [n]. Collective. */
void cracks_inject_fill(struct cracks *c, double dt, const double *residual);
