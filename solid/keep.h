/* Keeps the solid's whole state in memory and restores it, by the table of its state (solid/state_table.c): the content
 * of a checkpoint, and the other data that a later step may depend on to the bit (accelerations that are still valid,
 * contact's lists and its record of broken-bond pairs, which segments are tested first). So the same steps after a
 * restoration give the same results to the bit.
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
