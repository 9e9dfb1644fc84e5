/* Struts that are off: where a crack stands so wide open that the fluid outside is resolved in it.
 *
 * A strut is off while its ends have moved apart by more than c->gap, the same distance at which the crack's faces
 * become a part of the solid's surface. Its bit in the entry of its row then stands in `off`, not in `lanes`, so no sum
 * has it (cracks/rows.h). */
#pragma once
#include "cracks/cracks.h"

/* Whether a strut is off whose ends have moved apart by a vector, m. Not collective. */
int cracks_apart_is(const struct cracks *c, cracks_vec jump);
/* Switches struts by the present displacements. books: what leaves the struts' volume goes from content and void into
 * c->resolved; what comes back is full of fluid. Collective. */
void cracks_apart_look(struct cracks *c, int books);
