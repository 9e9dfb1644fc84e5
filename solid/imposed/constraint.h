/* Held and driven layers, unbreakable regions.  (001: sec. 3.3.11) */
#pragma once
#include "solid/state.h"

/* Sets the owned particles' flags from the regions, and the imposed values at the start. Not collective. */
void solid_constraint_mark(struct solid *s);
/* Dies (exit 2) on a region without a particle. Collective. */
void solid_constraint_check(const struct solid *s);
/* Sets the flags only, after regions have got new particles. Not collective. */
void solid_constraint_flags(struct solid *s);
/* Sets v of held and driven directions to the imposed velocity from t to t + dt (dt = 0: at t). The change of kinetic
 * energy is added to e_constraint. If two regions overlap, the later one counts. Not collective. */
void solid_constraint_velocity(struct solid *s, double t, double dt);
/* Sets imposed displacements to their values at t. Not collective. */
void solid_constraint_displacement(struct solid *s, double t);
/* Whether an imposed value varies in time. Not collective. */
int solid_constraint_varies(const struct solid *s);
/* Sets a = 0 where the velocity is imposed; power_constraint is the power of the reaction. Returns the sum of the
 * squared reactions, N2. Not collective. */
double solid_constraint_apply(struct solid *s);
/* Number of particles on the border of the turned box; they count as inside. Collective. */
long solid_constraint_on_border(const struct solid *s, const double low[3], const double high[3],
                                const struct solid_turn *turn);
/* Whether X0 of particle h is in the turned box or on its border (solid/geometry/on_surface.h). */
int solid_constraint_inside(const struct solid *s, int h, const double low[3], const double high[3],
                            const struct solid_turn *turn);
