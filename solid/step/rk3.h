/* The low-storage Runge-Kutta substep of the solid: three force sweeps.  (001: eqs 3.47-3.48) */
#pragma once
#include "solid/state.h"

void solid_rk3_step(struct solid *s, double dt); /* Collective. */
