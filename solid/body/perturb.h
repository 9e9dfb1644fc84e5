/* The seeded moves of a perturbed body's particles. */
#pragma once
#include "solid/input.h"

/* By how much a particle is moved in direction c, spacings: even in +-body->perturbation; 0 without. i, j: the indices
 * of a plate's cell on the lattice, or the point's number in the body's list and 0. Pure. */
double solid_perturb(const struct solid_body *body, long i, long j, int c);
