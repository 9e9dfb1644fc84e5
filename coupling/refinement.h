/* Refinement as a part of the step. */
#pragma once
#include "coupling/run.h"

/* Looks whether particles are to be refined, if it is due, and does it; the substeps follow. Collective. */
void refinement_look(struct run *r);
/* The rates of a plate that is, or may be, refined. Collective. */
void refinement_rates(struct run *r);
