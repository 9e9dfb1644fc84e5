/* What of the surface a checkpoint stores: the normals, which are not functions of the present state alone, because they are
 * looked at again only when they have turned. By owned particle, independent of ranks. */
#pragma once
#include "solid/normal.h"
#include "solid/surface.h"

int solid_surface_state_size(void); /* doubles a particle */
/* state [s->n][size]; zero off the interface. Not collective. */
void solid_surface_save(const struct solid *s, const struct solid_surface *f, double *state);
/* Once d, the bonds and the flags are back, ghosts too. Collective. */
void solid_surface_load(struct solid *s, struct solid_surface *f, const double *state);

/* The same within a run: kept [f->n, at most s->n] of the interface particles, by rising index. Not collective. */
void solid_surface_keep(const struct solid_surface *f, struct solid_facing *kept);
/* Once d, the bonds and the flags of that time are back. Collective. */
void solid_surface_restore(struct solid *s, struct solid_surface *f, const struct solid_facing *kept);
