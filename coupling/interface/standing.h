/* Whether a body stands on a wall, where the load on it is that with fluid beneath it. */
#pragma once
#include "coupling/run.h"
#include "physics/limits.h"

/* Sums over the particles of a body. */
struct standing {
    double volume; /* that is not beyond the side towards which the fluid's body force points, m3 */
    double area;   /* on this side, m2 */
};
/* bodies [PHYSICS_BODIES_MAX]: of each body. at_start: 1: by the particles' first places, 0: by the present ones.
 * Collective. */
void standing_measure(const struct run *r, int at_start, struct standing bodies[]);
/* Writes the sentence about a body, and returns 1, if there is one. Not collective. */
enum { STANDING_SENTENCE = 400 };
int standing_of(const struct run *r, int body, const struct standing *bodies, char sentence[STANDING_SENTENCE]);
