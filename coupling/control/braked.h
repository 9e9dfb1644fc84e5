/* Finds bodies in a flow that nothing holds, in a stage that damps the solid until it is at rest. */
#pragma once
#include "coupling/run.h"

enum { BRAKED_SENTENCE = 480 };
/* The damping that a stage with until: {quantity: rest} sets by itself acts on the velocity of each particle, so it
 * brakes a body that would go with the flow. Returns 1 and writes a sentence if the present stage has such a damping
 * and a body without held particles, its own or of a body that it is bonded to. Nothing is said without a flow, where
 * free bodies settle under their weight. Collective. */
int braked_of(const struct run *r, char sentence[BRAKED_SENTENCE]);
