/* Copies of other ranks' particles that families here need. */
#pragma once
#include "solid/state.h"

void solid_ghosts_update(struct solid *s); /* d (and v when damping needs it). Collective. */
void solid_ghosts_begin(struct solid *s);  /* The same, ended by the next force sweep. Collective. */
