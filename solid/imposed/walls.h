/* Walls: sides of the domain that particles do not pass. For solid/ and tests.
 *
 *     f = k (g_0 - g) n  per volume where g < g_0      k = 4 E/delta^2
 *
 * with g the distance of a particle from the side, n the side's normal into the domain, delta the horizon, and
 * g_0 half a spacing, or the distance at the start if that is less. So a body that stands on a wall at the start is not
 * pushed. The force is minus the gradient of the energy density (k/2) (g_0 - g)^2, and has no friction.
 *
 * k is half of the stiffness that an isotropic family has along n,
 *     c_0 integral of xi_n^2/|xi|^3 dV = 12 K/delta^2 = 8 E/delta^2      (in a plate in plane stress 9 E/delta^2)
 * which is what a particle at a face lacks: with the wall it is as stiff as an inner particle, and the stable step
 * stays that of the bonds.
 *
 * Where particles stand beyond a side from the start, as of a body that is held in a wall, the side is not a wall: they
 * are what others meet there. Between the middles of squares of a spacing the share of the wall that is there rises
 * smoothly from 0 to 1. It multiplies the energy density, so a particle that is squeezed from such a place under the
 * wall beside it gains nothing. Beside the domain a side goes on as at its edge. Particles that began beyond a side, or
 * are held along its normal, are not pushed. */
#pragma once
#include "solid/state.h"

/* Sets s->walls; NULL if no side of the input is a wall, or the solid is always rigid. Collective. */
void solid_walls_new(struct solid *s);
void solid_walls_free(struct solid_walls *walls);
/* Lists the particles that may touch a wall until they have moved by a quarter of the spacing. Does nothing without
 * walls. Not collective. */
void solid_walls_list(struct solid *s);
/* Largest k over density of the materials, 1/s2; 0 without walls. A face's particle has half of the bonds' rate, so the
 * walls shorten the stable step where bonds alone have less than twice this: of loose particles. */
double solid_walls_rate(const struct solid *s);
/* Whether a body may move out of a wall in which it stands, so that it meets the edge of its hole. */
int solid_walls_are_open(const struct solid *s);
/* The same of particles that are, within `ahead`, s, deeper than half a spacing beside the edge of such a hole, or of
 * a body that is held in a wall, 1/s2: it grows with the square of their depth. Makes the list again. Collective where
 * a body stands in a wall. */
double solid_walls_rate_deep(struct solid *s, double ahead);
/* Adds the forces to a; s->walls must not be NULL. Not collective. */
void solid_walls_push(struct solid *s);
/* Potential energy of the walls' forces with the present displacements, this rank's share, J; 0 without walls. */
double solid_walls_energy(const struct solid *s);
/* Of velocity Verlet, with the velocities at the end of a substep: gives the particles that met a wall or left it in
 * the substep back, along its normal, what the mean of the forces at both ends has given them too much. Slow ones,
 * which other forces press against the wall, are left as they are, and come to rest. dt: of the substep, s. Not
 * collective. */
void solid_walls_correct(struct solid *s, double dt);
/* What the last sweeps' forces have given to the kinetic energy beyond what they took from the potential, this rank's
 * share, J; 0 without walls. A substep in which a particle meets a wall or leaves it gives some, if it is not settled.
 * Of velocity Verlet, whose forces work with their mean at both ends of a substep, it is exact; a call sets it to 0. */
double solid_walls_excess(struct solid *s);
/* The sum of all that solid_walls_excess has returned, J; 0 without walls. */
double solid_walls_given(const struct solid *s);
/* Power of the last sweep's forces, this rank's share, W; 0 without walls. */
double solid_walls_power(const struct solid *s);
/* The impulse on the solid: set to 0, increased by those of the last and the last but one sweep's forces over the times
 * `now` and `then`, s, and added to impulse, this rank's share, N s. They do nothing without walls. */
void solid_walls_impulse_begin(struct solid *s);
void solid_walls_impulse_add(struct solid *s, double now, double then);
void solid_walls_impulse(const struct solid *s, double impulse[3]);
