/* Damage of particles.  (001: eq. 3.28) */
#pragma once
#include "solid/state.h"

void solid_damage_measure(const struct solid *s,
                          double *phi); /* [n], 1 - sum(lambda Gamma V)/sum(Gamma V). Not collective. */
