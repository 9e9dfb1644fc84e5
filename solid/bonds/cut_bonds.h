/* Initial cracks. Inside the room only. */
#pragma once
#include "solid/body/cloud.h"

/* Breaks the bonds that the input's cuts cross, from both ends, once weights are known: V_h and with it the surface
 * correction are those of the body without cracks, so a crack's lips are not stiffened (000, 003). What breaks here is
 * damage, but no energy released. cloud [bodies]: NULL for a lattice. Dies (exit 2) on a cut that crosses no bond.
 * Collective. */
void solid_cut_bonds(struct solid *s, struct solid_cloud *const *cloud);
