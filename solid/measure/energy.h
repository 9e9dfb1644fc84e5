/* Energies of the solid, total and by particle; computed only for output.  (001: eqs 3.23, 3.40) */
#pragma once
#include "solid/state.h"

struct solid_energy {
    double kinetic, strain, contact; /* J, whole solid */
    double damped, fracture;         /* dissipated by damping, released by bonds so far, J, whole solid */
};
struct solid_energy solid_energy_measure(struct solid *s); /* Collective. */
/* For each particle, [n]: the energy in its halves of its intact bonds, J/m3, and the largest stretch of these, -1
 * without an intact bond. Ghosts must be current. Not collective. */
void solid_energy_bonds(const struct solid *s, double *energy, double *stretch);
void solid_energy_bonds_of(const struct solid *s, int h, double *energy, double *stretch); /* of one particle */
