/* A plate (polygons) cut from the plane's lattice. For solid/ only. */
#pragma once
#include "solid/body/cloud.h"
#include "solid/body/sites.h"

/* The cloud of a polygon's particles, numbered as in sites. Collective (same input on all ranks). */
struct solid_cloud *solid_plane_cloud(const struct solid_input *in, const struct solid_body *body,
                                      const struct solid_sites *sites);
/* Dies (exit 2) if two polygons contain the same cell. Collective (same input on all ranks). */
void solid_plane_overlap_check(const struct solid_input *in, struct solid_sites *const *sites);
