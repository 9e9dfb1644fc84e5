/* Ghosts: copies of other ranks' particles that families here need. */
#pragma once
#include "solid/state.h"

void solid_ghosts_update(struct solid *s); /* updates d (and v if damping needs it). Collective. */
void solid_ghosts_begin(struct solid *s);  /* the same, completed by the next force sweep. Collective. */
