/* What is given to flow where nothing can: the forcing lets it through a body, and the pressure's drop is the method's,
 * not the flow's. */
#pragma once
#include "coupling/run.h"

/* One sentence for each side, or driven direction, that gives a flow and has no way out, as the bodies stand now;
 * returns how many. Collective. */
enum { BLOCKED_MAX = 6, BLOCKED_SENTENCE = 200 };
int blocked_of(struct run *r, char sentence[BLOCKED_MAX][BLOCKED_SENTENCE]);
