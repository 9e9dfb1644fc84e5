/* The force sweep over a lattice. */
#pragma once
#include "solid/bonds/lattice.h"

/* a [.] = bond (and damping) acceleration of the body's owned particles, m/s2, in two halves: the first does without
 * ghosts, which must be current for the second. Each returns the power that its bonds' damping takes out, W (>= 0). */
double solid_sweep_lattice_begin(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep);
double solid_sweep_lattice_end(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep);
/* Ghosts' d and v into the dense box: the first half reads them times 0 before they are current, so they must be
 * numbers. Not collective. */
void solid_sweep_lattice_refill(const struct solid *s, const struct solid_lattice *lattice);
