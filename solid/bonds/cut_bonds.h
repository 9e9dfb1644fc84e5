/* Initial cracks. For solid/ only. */
#pragma once
#include "solid/body/cloud.h"

/* Breaks the bonds that the input's cuts cross, from both ends, after the weights are computed: V_h and the surface
 * correction are those of the body without cracks, so that a crack's faces are not stiffened (000, 003). These broken
 * bonds count as damage, but release no energy. cloud [bodies]: NULL for a lattice. Dies (exit 2) on an initial crack
 * that crosses no bond. Collective. */
void solid_cut_bonds(struct solid *s, struct solid_cloud *const *cloud);
