/* The force sweep over the softening bonds. */
#pragma once
#include "solid/bonds/soft.h"
#include "solid/bonds/store.h"

/* Adds the softening bonds' accelerations (and damping's) to a, after the sweeps over the stores have filled it. Where
 * bonds may break their histories are brought up to date first, and those at s_c are broken; the energy that this
 * releases is added to s->e_fracture. Ghosts must be current. Returns the power that damping dissipates, W (>= 0). */
double solid_sweep_soft(struct solid *s, const struct solid_sweep *sweep);
/* The same before that, for the dilatations of the families of bodies that have them (solid/force/dilatation.h): adds
 * to the sums that the sweeps over the stores have left, over the density of the store [n], m/s2. There the histories
 * of these bodies' bonds are brought up and their bonds broken, and solid_sweep_soft leaves them as they are. */
void solid_sweep_soft_extend(struct solid *s, int may_break, double *extension, double *weight);
/* Their strain energy, J, this rank's share. Ghosts must be current. */
double solid_sweep_soft_energy(const struct solid *s);
