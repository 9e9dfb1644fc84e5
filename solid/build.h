/* Steps of solid_new that are repeated after a refinement. For solid/ only. */
#pragma once
#include "solid/body/cloud.h"
#include "solid/bonds/store.h"

/* Makes the ghosts of the present stores, and links them. sites: of the bodies, NULL if all have clouds. Collective. */
void solid_build_ghosts(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud);
/* The constants of a material's bonds on a lattice. Not collective. */
struct solid_law solid_build_law(const struct solid_input *in, int material);
/* Sets the materials of the particles where a body has several. Collective. */
void solid_build_materials(struct solid *s, struct solid_sites *const *sites);
/* Sets X0, volumes, bodies and weights, once the arrays exist. Collective. */
void solid_build_places(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud);
void solid_build_edges(struct solid *s); /* Not collective. */
/* Counts the bonds, and the bytes of lambda. Collective. */
void solid_build_counts(struct solid *s);
