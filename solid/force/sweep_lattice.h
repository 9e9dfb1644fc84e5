/* The force sweep over a lattice. */
#pragma once
#include "solid/bonds/lattice.h"

/* a [.] = acceleration of the body's owned particles by bonds (and damping), m/s2, in two halves: the first half needs
 * no ghosts, the second needs current ones. Each returns the power that its bonds' damping dissipates, W (>= 0). */
double solid_sweep_lattice_begin(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep);
double solid_sweep_lattice_end(struct solid *s, struct solid_lattice *lattice, const struct solid_sweep *sweep);
/* Copies ghosts' d and v to the field arrays. The first half reads them before they are current and multiplies them by
 * 0, so they must be finite. Not collective. */
void solid_sweep_lattice_refill(const struct solid *s, const struct solid_lattice *lattice);
