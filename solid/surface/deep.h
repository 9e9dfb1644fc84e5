/* Which particles stand deep in their body: nearly all of their horizon is filled with bonded material. */
#pragma once
#include <stdint.h>

struct solid;

/* least [s->n] <- the least number of intact bonds with which a particle counts as deep: with it the bonded volume is
 * nine tenths of a full family's. On a lattice with a horizon of 3 spacings these are the particles from the third
 * layer below a plane face or a crack on; in a wall of four layers there are none. UINT16_MAX: never, as for particles
 * on no lattice, which may stand closer in places. Not collective. */
void solid_deep_least_bonds(const struct solid *s, uint16_t *least);
/* Present over undeformed volume of a deep particle's surroundings, det F by its six nearest particles; 0 if one of
 * them is missing. Ghosts must be current. Not collective. */
double solid_deep_volume_ratio(const struct solid *s, int h);
