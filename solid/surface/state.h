/* The surface's state in a checkpoint: the normals. They are not a function of the present state alone, because a
 * normal is recomputed only when its reference bonds have rotated. By owned particle, independent of ranks. */
#pragma once
#include "solid/surface/normal.h"
#include "solid/surface/surface.h"

int solid_surface_state_size(void); /* doubles a particle */
/* state [s->n][size]; zero off the interface. Not collective. */
void solid_surface_state_save(const struct solid *s, const struct solid_surface *f, double *state);
/* To be called once d, bonds and flags are restored, with those of the ghosts. Collective. */
void solid_surface_state_load(struct solid *s, struct solid_surface *f, const double *state);

/* The surface as part of a snapshot (solid/snapshot.h). */
struct solid_surface_snapshot;
struct solid_surface_snapshot *solid_surface_state_snapshot_new(const struct solid *s);
void solid_surface_state_snapshot_free(struct solid_surface_snapshot *k);
void solid_surface_state_snapshot_take(struct solid_surface_snapshot *k,
                                       const struct solid_surface *f); /* Not collective. */
/* To be called once bonds and flags of that time are restored. tracker: of these bonds; NULL: since then no particle
 * has joined or left the interface or lost a bond. Not collective. */
void solid_surface_state_snapshot_restore(const struct solid_surface_snapshot *k, struct solid *s,
                                          struct solid_surface *f, const struct solid_broken_tracker *tracker);
