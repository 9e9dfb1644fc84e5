/* How far bonds are stretched, by a few bonds of each particle: whether the stable step of the unstrained solid still
 * holds.
 *
 * Near a stretch s the frequencies of a solid rise by up to s (solid_rates_strained). A solid whose bonds break at a
 * small stretch is never strained as far. */
#pragma once
#include "solid/state.h"

struct solid_strained; /* opaque */

/* NULL unless bonds may be stretched by more than a fiftieth in the present stage. s is borrowed. Collective. */
struct solid_strained *solid_strained_new(struct solid *s);
void solid_strained_free(struct solid_strained *strained);
/* The bonds are chosen again, of those that are intact then. strained may be NULL. Not collective. */
void solid_strained_forget(struct solid_strained *strained);
/* The largest stretch or compression of up to three short bonds of each particle, in different directions; 0 as long as
 * no particle has moved by a hundredth of a spacing. Updates the ghosts. Collective. */
double solid_strained_stretch(struct solid_strained *strained);
