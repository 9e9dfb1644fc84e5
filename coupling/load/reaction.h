/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
#pragma once

#include "coupling/load/load.h"

struct reaction; /* opaque: r->reaction */

extern const struct load_kind reaction_kind;

/* How far the pressure inside a body has been from the mean that its cracks take (coupling/load/inner_pressure.c):
 * largest standard deviation since the last call, Pa. Not collective, the same on all ranks. */
double reaction_take_uneven(const struct run *r);
/* Mean couple over the last step, about the domain's centre, of what the fluid inside the bodies gets itself, N m.
 * Collective. */
void reaction_inner_couple(const struct run *r, double couple[3]);
/* The next step adds up its works, which takes a few readings of the markers and of the inner fluid. Not collective. */
void reaction_add_works(struct run *r);
/* Watch the inner fluid (coupling/load/inner_watch.h): after each accepted step; every so many steps. Collective. */
void reaction_watch_note(struct run *r);
void reaction_watch_check(struct run *r);
/* The next step sorts the markers of the inner fluid (ibm_markers_sort_again). Not collective, on all ranks. */
void reaction_sort_again(struct run *r);
/* Means over the last step, if it has added up its works, W. The slip's loss is the work that the forcing takes from
 * the solid and does not give to the fluid; of a solid at rest, that at the step's end. The inner fluid's power is that
 * of what it gives back, on the solid and on the fluid deep inside. Collective. */
double reaction_slip_loss(struct run *r);
double reaction_inner_power(const struct run *r);
