/* Refinement as a part of the time step. */
#pragma once
#include "coupling/run.h"

/* If a check is due: finds the particles to refine, and refines them; the rates are updated. Collective. */
void refinement_check(struct run *r);
/* Updates the rates of a plate that is refined or may be refined. Collective. */
void refinement_rates(struct run *r);
