/* Held and driven layers, unbreakable regions.  (001: sec. 3.3.8) */
#pragma once
#include "solid/state.h"

/* Flags of the owned particles from the regions, and what is imposed at the start. Not collective. */
void solid_constraint_mark(struct solid *s);
/* Dies (exit 2) on a region without a particle. Collective. */
void solid_constraint_check(const struct solid *s);
/* The flags alone, of regions that have got new particles. Not collective. */
void solid_constraint_flags(struct solid *s);
/* v of held and driven directions as imposed from t to t + dt (dt = 0: at t); e_constraint takes what that changes in
 * kinetic energy. Where two regions overlap the later one holds. Not collective. */
void solid_constraint_velocity(struct solid *s, double t, double dt);
/* d where a displacement is imposed, as at t. Not collective. */
void solid_constraint_displacement(struct solid *s, double t);
/* Whether something imposed varies in time. Not collective. */
int solid_constraint_varies(const struct solid *s);
/* a = 0 where the velocity is imposed; power_constraint = what the reaction puts in. Returns the sum of the squared
 * reactions, N2. Not collective. */
double solid_constraint_apply(struct solid *s);
/* X0 of particle h in the box. */
int solid_constraint_inside(const struct solid *s, int h, const double low[3], const double high[3]);
