/* Warns of particles that the scene's initial cracks leave without a bond. */
#pragma once

struct run;

enum { UNBONDED_SENTENCE = 320 };
/* Writes one sentence if there are some at the start. Returns whether there are. Collective. */
int unbonded_of(const struct run *r, char sentence[UNBONDED_SENTENCE]);
