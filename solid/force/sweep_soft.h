/* The force sweep over the softening bonds. */
#pragma once
#include "solid/bonds/soft.h"
#include "solid/bonds/store.h"

/* Adds the softening bonds' accelerations (and damping's) to a, after the sweeps over the stores have filled it. Where
 * bonds may break their histories are brought up to date first, and those at s_c are broken; the energy that this
 * releases is added to s->e_fracture. Ghosts must be current. Returns the power that damping dissipates, W (>= 0). */
double solid_sweep_soft(struct solid *s, const struct solid_sweep *sweep);
/* Their strain energy, J, this rank's share. Ghosts must be current. */
double solid_sweep_soft_energy(const struct solid *s);
