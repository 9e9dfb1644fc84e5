/* Dimensionless groups. */
#pragma once
#include "coupling/run.h"

enum { CHECK_GROUPS_SENTENCE = 320 };
/* Prints the groups, and the critical stretch and the wave speeds of each material. Not collective: rank 0 prints. */
void check_groups_print(const struct run *r);
/* Whether a material is lighter than a hundredth of the fluid, as if its density were given in another unit. Not
 * collective. */
int check_groups_light(const struct scene *scene, int material, char sentence[CHECK_GROUPS_SENTENCE]);
