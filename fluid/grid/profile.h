/* Profiles of the velocity normal to a section: inflow profiles, and developed flow as an initial state. */
#pragma once
#include "fluid/fluid.h"

/* The developed flow on this grid through the section normal to `direction`, at the cell centres, with discrete mean
 * one: [n_b][n_a], a < b the other directions. Between two walls the parabola y (h - y) + dy^2/4, which the second
 * difference with reflected ghosts holds exactly; in a duct the discrete solution of lap q = -1; without walls one
 * everywhere. */
void fluid_profile_developed(const struct fluid_input *in, int direction, double *profile);
/* The profile of an inflow side, into the domain, m/s: [n_b][n_a]. Dies (exit 4) on a file that cannot be used.
 * Collective. */
void fluid_profile_inflow(const struct fluid_input *in, int direction, int side, double *profile);
