/* The solid's whole state kept in memory and put back: what the table of its state (solid/state_table.c) says is kept.
 * That is what a checkpoint stores, and what else a later step may depend on to the bit (accelerations that still hold,
 * contact's lists and its record of torn bonds, which segments were judged first). So the same steps from a state put
 * back are the same to the bit.
 *
 * The arrays of the particles are copied each time; bonds, contact's lists and its record only as far as they have
 * changed. Several states may be kept at a time. After one is restored, those kept after it are invalid until they are
 * taken again. A state is taken between steps, after the surface was updated, and is valid until the next
 * refinement. */
#pragma once
#include "solid/surface/surface.h"

struct solid_keep; /* opaque */

/* surface may be NULL; may_break: 0 if no bond ever breaks. No state is kept yet. Not collective. */
struct solid_keep *solid_keep_new(const struct solid *s, const struct solid_surface *surface, int may_break);
void solid_keep_free(struct solid_keep *k);
void solid_keep_take(struct solid_keep *k, struct solid *s, const struct solid_surface *surface); /* Not collective. */
/* Restores also the ghosts' displacements and velocities. Not collective. */
void solid_keep_restore(struct solid_keep *k, struct solid *s, struct solid_surface *surface);
