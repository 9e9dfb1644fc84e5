/* Struts that are switched off, because the crack is so wide open there that the grid resolves the fluid in it.
 *
 * A strut is off while its ends have moved apart by more than c->gap, the same distance at which the crack's faces
 * become a part of the solid's surface. Its bit in its row's entry is then in `off`, not in `lanes`, so that no
 * sum contains it (cracks/rows.h). */
#pragma once
#include "cracks/cracks.h"

/* Whether a strut whose ends have moved apart by this vector, m, is off. Not collective. */
int cracks_resolved_is(const struct cracks *c, cracks_vec jump);
/* Switches struts off and on by the present displacements. moves_volume: 1: the volume of a strut that is switched off
 * is moved from content and void to c->resolved; one that is switched on is full of fluid. Collective. */
void cracks_resolved_update(struct cracks *c, int moves_volume);
