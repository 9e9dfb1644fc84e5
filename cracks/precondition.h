/* The preconditioner of the pressures: an approximation of A^-1, symmetric and positive, which is the same on any
 * number of ranks but for rounding. */
#pragma once
#include "cracks/cracks.h"

/* For the present set and conductances, and the struts' part of A 1 (work->ones_stiff, of_ones). Collective. */
void cracks_precondition_begin(struct cracks *c, double dt);
/* work->z = about A^-1 work->residual over the full particles. Collective. */
void cracks_precondition(const struct cracks *c, double dt);
