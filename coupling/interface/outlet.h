/* Whether bodies stand close before a side through which the flow leaves, so that the load on them is too small. */
#pragma once
#include "coupling/run.h"

/* Writes a sentence for each such side of a body; returns how many. At the start of a run. Collective. */
enum { OUTLET_MAX = 6, OUTLET_SENTENCE = 400 };
int outlet_of(const struct run *r, int body, char sentence[OUTLET_MAX][OUTLET_SENTENCE]);
