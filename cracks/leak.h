/* Carter's leak-off: what the faces of a crack lose into a solid whose pores are not computed.
 *
 * A face loses 2 C (t - t0)^(1/2) per area from t0 on, when the particle was full for the first time. Both faces lose.
 * Of a particle that is not full no more leaks off than it holds. */
#pragma once
#include "cracks/cracks.h"

/* The losses from t to t + dt, in c->leak, subtracted from the residual; the sets are those of the start. Returns their
 * sum on this rank. Not collective. */
double cracks_leak_source(struct cracks *c, double t, double dt, double *b);
/* Books them, and the particles that are full since now = t + dt. Collective. */
void cracks_leak_book(struct cracks *c, double now);
