/* Strain energy of the bonds. For solid/ only. */
#pragma once
#include "solid/state.h"

/* This rank's share, J. Ghosts must be current. Not collective. */
double solid_strain_energy(const struct solid *s);
