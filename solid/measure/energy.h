/* Energies of the solid, whole and by particle; computed only when written.  (001: eq. 3.23) */
#pragma once
#include "solid/state.h"

struct solid_energy {
    double kinetic, strain; /* J, whole solid */
};
struct solid_energy solid_energy_measure(struct solid *s); /* Collective. */
/* Of each particle, [n]: the energy in its halves of its intact bonds, J/m3, and the largest of their stretches, -1
 * where none is left. Ghosts must be current. Not collective. */
void solid_energy_bonds(const struct solid *s, double *energy, double *stretch);
void solid_energy_bonds_of(const struct solid *s, int h, double *energy, double *stretch); /* one of them */
