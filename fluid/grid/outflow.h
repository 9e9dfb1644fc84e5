/* Convective outflow  du/dt + U_c du/dn = 0  for the normal velocity on a side, mass-conserving.  (001: sec. 5.1)
 *
 * The derivative is one-sided, from the face inside: dudn = (u_face - u_inside)/d. The tangential components need no
 * equation of their own: with an even extension their flux through the side is the upwind one.
 *
 * U_c is the mean velocity out of the domain. A body that leaves faster than that pushes the fluid before it out with
 * its own velocity, and the body itself takes its inner fluid along; carried with the mean the faces would hold both
 * back, as a wall does. So where a body is near, U_c is at each face the larger of the mean and the flow's own velocity
 * at the face inside. */
#pragma once
#include "fluid/grid/boundary.h"

/* The mean velocity out of the domain through each convective side, never negative, and whether a body is near. Once a
 * step. Collective. */
void fluid_outflow_begin(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]);
/* One stage: plane = u + a F + b F_old with F = -U_c du/dn, which replaces F_old (stored at the face in rate). Then a
 * uniform correction makes the flux out of all sides equal to the flux into them. q, rate [3]. Collective. */
void fluid_outflow_advance(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                           double *const rate[3], double a, double b);
/* Sets the planes to the values in q. Not collective. */
void fluid_outflow_take(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]);
