/* Dimensionless groups. */
#pragma once
#include "coupling/run.h"

/* The largest inflow velocity or driven velocity of the scene, m/s. Not collective. */
double check_groups_velocity(const struct scene_fluid *f);
/* Writes a sentence and returns 1 if the cells are too coarse for viscosity to have an effect; else returns 0. Not
 * collective. */
enum { CHECK_GROUPS_SENTENCE = 320 };
int check_groups_unresolved(const struct run *r, double u, char sentence[CHECK_GROUPS_SENTENCE]);
/* Prints the groups, and the critical stretch and the wave speeds of each material. Not collective: rank 0 prints. */
void check_groups_print(const struct run *r);
/* Whether a material is lighter than a hundredth of the fluid, as if its density were given in another unit. Not
 * collective. */
int check_groups_light(const struct scene *scene, int material, char sentence[CHECK_GROUPS_SENTENCE]);
