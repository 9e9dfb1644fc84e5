/* The particles' volume in the cells of the medium, and what the medium measures with it. */
#pragma once
#include "coupling/medium/medium.h"

struct run;

/* Deposits the particles' volume in the medium's cells, at most once a step. Collective. */
void deposit_update(struct run *r);
/* The particles' volume, spread to the cells as a force on it is (medium_spread). Collective. */
const double *deposit_spread(struct run *r);
/* What the medium measures now. NaN instead of a permeability that would mean nothing: nothing drives the fluid along
 * the direction alone (r->measured.why), or no way through the medium is left. Collective. */
struct medium_values deposit_measure(struct run *r);
