/* Carter's leak-off: the volume that a crack loses through its faces into a solid whose pores are not computed.
 *
 * Each of the two faces loses 2 C (t - t0)^(1/2) per area from t0 on, when the particle was full for the first time.
 * A particle that is not full loses at most the volume that it holds. */
#pragma once
#include "cracks/cracks.h"

/* The losses from t to t + dt, in c->leak, subtracted from the residual b; which particles are full is taken at t.
 * Returns the sum on this rank. Not collective. */
double cracks_leak_off_source(struct cracks *c, double t, double dt, double *b);
/* Subtracts the losses from the content, and records the particles that are full for the first time at now = t + dt.
 * Collective. */
void cracks_leak_off_add(struct cracks *c, double now);
/* After the flow of the substep: what a particle that has run empty in it did not hold has not leaked. left: the
 * residual, volume - content of such a particle with its sign turned, m3. Collective. */
void cracks_leak_off_return(struct cracks *c, double *left);
