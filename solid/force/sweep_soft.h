/* The force sweep over the softening bonds. */
#pragma once
#include "solid/bonds/soft.h"
#include "solid/bonds/store.h"

/* Adds the softening bonds' accelerations (and damping's) to a, after the sweeps over the stores have filled it. If
 * bonds may break, their histories are updated first, and bonds at s_c are broken; the released energy is added to
 * s->e_fracture. Ghosts must be current. Returns the power that damping dissipates, W (>= 0). */
double solid_sweep_soft(struct solid *s, const struct solid_sweep *sweep);
/* The first pass of bodies with dilatation (solid/force/dilatation.h), before solid_sweep_soft: adds to the sums over
 * families that the sweeps over the stores have computed, over the density of the store [n], m/s2. It also updates the
 * histories of these bodies' bonds and breaks bonds; solid_sweep_soft then does neither. */
void solid_sweep_soft_extend(struct solid *s, int may_break, double *extension, double *weight);
/* Their strain energy, J, this rank's share. Ghosts must be current. */
double solid_sweep_soft_energy(const struct solid *s);
