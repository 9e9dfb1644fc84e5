/* Parts of solid_new that a body whose particles have changed goes through again. Inside the room only. */
#pragma once
#include "solid/body/cloud.h"
#include "solid/bonds/store.h"

/* Ghosts of the stores as they are, and their links. sites: of the bodies, NULL where all have clouds. Collective. */
void solid_build_ghosts(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud);
/* X0, volumes, bodies and weights, once there are arrays. Collective. */
void solid_build_places(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud);
void solid_build_edges(struct solid *s); /* Not collective. */
/* Bonds there are, and the bytes that lambda takes. Collective. */
void solid_build_counts(struct solid *s);
