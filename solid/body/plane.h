/* A plate cut out of the plane's lattice: polygons. Inside the room only. */
#pragma once
#include "solid/body/cloud.h"
#include "solid/body/sites.h"

/* The particles of a polygon, numbered as the sites say. Collective (all ranks alike). */
struct solid_cloud *solid_plane_cloud(const struct solid_input *in, const struct solid_body *body,
                                      const struct solid_sites *sites);
/* Dies (exit 2) where two polygons want the same cell. Collective (all ranks alike). */
void solid_plane_overlap_check(const struct solid_input *in, struct solid_sites *const *sites);
