/* Finds given steps that are longer than the stable ones. */
#pragma once
#include "coupling/run.h"

/* Writes a sentence for each limit of the present stage that its given step, or its given number of substeps, exceeds:
 * of the fluid, with the velocities that the scene gives, and of the solid; for fewer substeps than an automatic number
 * has; and for a step so short that nothing moves. Returns how many. Dies (exit 2) on a step that cannot advance the
 * state or the time. In an elastic stage step_begin_stage comes first. Collective. */
enum { OVERSTEP_MAX = 4, OVERSTEP_SENTENCE = 320 };
int overstep_of(struct run *r, char sentence[OVERSTEP_MAX][OVERSTEP_SENTENCE]);
