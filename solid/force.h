/* The parts of a force sweep, for the integrators. Inside the room only. */
#pragma once
#include "solid/solid.h"

/* a = (bonds + pairwise damping k_d)/rho of all bodies; power_damped. Not collective. */
void solid_force_bonds(struct solid *s, int may_break, double damping_relative);
/* a += load/rho + body force - k_a v; power_load, power_damped. Not collective. */
void solid_force_loads(struct solid *s, double damping_absolute);
/* What comes after bonds and contact: loads, added mass, constraints, and their powers. Not collective. */
void solid_force_rest(struct solid *s);
