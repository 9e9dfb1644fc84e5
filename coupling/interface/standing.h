/* Whether a body stands on a wall, where the load on it is that with fluid beneath it. */
#pragma once
#include "coupling/run.h"

/* Writes the sentence about a side towards which the fluid's body force points, and returns 1, if there is one.
 * at_start: 1: by the particles' first places, 0: by the present ones. Collective. */
enum { STANDING_SENTENCE = 400 };
int standing_of(const struct run *r, int body, int at_start, char sentence[STANDING_SENTENCE]);
