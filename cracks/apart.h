/* Switches struts off and on: where a crack stands wide open the fluid outside takes over (cracks/off.h). */
#pragma once
#include "cracks/cracks.h"

/* Switches struts by the present displacements. books: what leaves the struts' volume goes from content and void into
 * c->resolved; what comes back is full of fluid. Collective. */
void cracks_apart_look(struct cracks *c, int books);
