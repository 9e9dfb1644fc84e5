/* Breakage of materials whose limit of the stretch follows the other bonds, as LAMMPS's pair_style peri/pmb has it:
 *
 *     a bond breaks if s > min(s0_h, s0_l)     s0_h = s00 - alpha min(s of the bonds of h)   of the step before
 *
 * A family under pressure bears a larger tension. Forces of the step in which a bond is found beyond its limit still
 * contain it. The material's fracture energy is infinite, so the sweeps over the bond stores never break its bonds, and
 * cost what they cost without this. */
#pragma once
#include "solid/state.h"

/* After the forces of a sweep in which bonds may break: breaks bonds by the present limits, then finds those of the
 * next step. Before the first sweep the limits are infinite, as is that of a particle without bonds. s->stretch_limit
 * must not be NULL; the ghosts' displacements must be current. Collective. */
void solid_sweep_limit(struct solid *s);
