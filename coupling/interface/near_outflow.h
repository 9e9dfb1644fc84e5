/* Whether bodies stand close before a side through which the flow leaves, so that the load on them is too small. */
#pragma once
#include "coupling/run.h"

/* Writes a sentence for each such side of a body; returns how many. At the start of a run. Collective. */
enum { NEAR_OUTFLOW_MAX = 6, NEAR_OUTFLOW_SENTENCE = 400 };
int near_outflow_of(const struct run *r, int body, char sentence[NEAR_OUTFLOW_MAX][NEAR_OUTFLOW_SENTENCE]);
