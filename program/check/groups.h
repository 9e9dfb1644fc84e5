/* Dimensionless groups. */
#pragma once
#include "coupling/run.h"

/* The largest inflow velocity or driven velocity of the scene, m/s. Not collective. */
double check_groups_velocity(const struct scene_fluid *f);
/* Prints the groups, and the critical stretch and the wave speeds of each material. Not collective: rank 0 prints. */
void check_groups_print(const struct run *r);
