/* Snapshots: copies of the solid's whole state in memory, from which it is restored, by the table of its state
 * (solid/state_table.c). A snapshot holds the content of a checkpoint, and the other data that a later step may depend
 * on to the bit (accelerations that are still valid, contact's lists and its record of broken-bond pairs, which
 * segments are tested first). So the same steps after a restoration give the same results to the bit.
 *
 * The arrays of the particles are copied each time; bonds, contact's lists and its record only as far as they have
 * changed. There may be several snapshots at a time. After one is restored, later ones are invalid until they are taken
 * again. A snapshot is taken between steps, after the surface was updated, and is valid until the next refinement. */
#pragma once
#include "solid/surface/surface.h"

struct solid_snapshot; /* opaque */

/* surface may be NULL; may_break: 0 if no bond ever breaks. The snapshot is empty. Not collective. */
struct solid_snapshot *solid_snapshot_new(const struct solid *s, const struct solid_surface *surface, int may_break);
void solid_snapshot_free(struct solid_snapshot *k);
void solid_snapshot_take(struct solid_snapshot *k, struct solid *s,
                         const struct solid_surface *surface); /* Not collective. */
/* Restores also the ghosts' displacements and velocities. Not collective. */
void solid_snapshot_restore(struct solid_snapshot *k, struct solid *s, struct solid_surface *surface);
