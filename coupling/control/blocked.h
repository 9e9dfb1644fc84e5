/* Finds prescribed flow without an open path out: the forcing would push it through a body, and the pressure drop would
 * be an artefact of the method. */
#pragma once
#include "coupling/run.h"

/* Writes one sentence for each side, or driven direction, whose prescribed flow has no way out with the bodies at their
 * present positions. Returns how many. Collective. */
enum { BLOCKED_MAX = 6, BLOCKED_SENTENCE = 200 };
int blocked_of(struct run *r, char sentence[BLOCKED_MAX][BLOCKED_SENTENCE]);
