/* Lloyd's iteration towards a centroidal Voronoi tessellation. */
#pragma once
#include "meshless/arrange/pixels.h"

/* Moves the points x, all inside the domain, each to the centroid of its cell, until the energy changes by less than
 * 1e-6 of itself. Fills in iterations and energy. Collective (same points on all ranks). */
void meshless_centroidal(struct meshless_points *p, struct meshless_pixels *g);
