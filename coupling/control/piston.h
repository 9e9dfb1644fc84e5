/* Finds bodies whose imposed motion, or whose motion under loads, displaces fluid that has no open path out, as a
 * piston in a closed duct. The forcing would press the fluid through the body. */
#pragma once
#include "coupling/run.h"

enum { PISTON_SENTENCE = 320 };
/* Writes a sentence if so with the bodies at their present positions. Returns 1 then. Bodies without imposed motion, or
 * of which parts are imposed different motions, give way: they are taken for fluid. A free body that spans the domain
 * across what pushes it (loads, weight, the velocity that it begins with) is examined alone. Collective. */
int piston_of(struct run *r, char sentence[PISTON_SENTENCE]);
