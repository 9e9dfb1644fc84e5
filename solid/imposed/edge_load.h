/* Loads on the edges of plates that are polygons. For solid/ only. */
#pragma once
#include "solid/imposed/external_loads.h"

struct solid_edges; /* opaque: the boundary under the input's loads */

/* Dies (exit 2) if a load's edge is not an edge of a body. Collective (same input on all ranks). */
struct solid_edges *solid_edge_load_new(const struct solid_input *in);
void solid_edge_load_free(struct solid_edges *edges);
/* The k-th load's length of edge times thickness over the volume that bears it, for each owned particle: times the
 * traction this is its force, N/m3. per_volume [s->n], 1/m, is 0 before. Collective. */
void solid_edge_load_per_volume(const struct solid *s, struct solid_sites *const *sites,
                                const struct solid_edges *edges, int k, double *per_volume);
/* The same for a plate with particles of several sizes. of_cloud gives each its part of the edge. Collective. */
void solid_edge_load_per_volume_refined(const struct solid *s, solid_edge_load_lengths *of_cloud, int k,
                                        double *per_volume);
