/* Bodies whose shapes are not bonded to one another. For solid/ only. */
#pragma once
#include "solid/state.h"

/* Breaks the bonds between particles of different shapes of a body with contacts_broken, from both ends. A particle
 * belongs to the shape that it lies deepest in. As with an initial crack these bonds count as damage and release no
 * energy, and the particles repel each other by contact. Not collective. */
void solid_cut_shapes(struct solid *s);
