/* What of the surface a checkpoint stores: the normals, which are not functions of the present state alone, because
 * they are looked at again only when they have turned. By owned particle, independent of ranks. */
#pragma once
#include "solid/surface/normal.h"
#include "solid/surface/surface.h"

int solid_surface_state_size(void); /* doubles a particle */
/* state [s->n][size]; zero off the interface. Not collective. */
void solid_surface_state_save(const struct solid *s, const struct solid_surface *f, double *state);
/* Once d, the bonds and the flags are back, ghosts too. Collective. */
void solid_surface_state_load(struct solid *s, struct solid_surface *f, const double *state);

/* The surface as part of a kept state (solid/keep.h). */
struct solid_surface_keep;
struct solid_surface_keep *solid_surface_state_keep_new(const struct solid *s);
void solid_surface_state_keep_free(struct solid_surface_keep *k);
void solid_surface_state_keep_take(struct solid_surface_keep *k, const struct solid_surface *f); /* Not collective. */
/* Once bonds and flags of that time are back; lost: of them; NULL: nobody has come to the interface, gone from it or
 * lost a bond since. Not collective. */
void solid_surface_state_keep_restore(const struct solid_surface_keep *k, struct solid *s, struct solid_surface *f,
                                      const struct solid_lost *lost);
