/* Loads on the edges of plates that are polygons. For solid/ only. */
#pragma once
#include "solid/imposed/external_loads.h"

struct solid_edges; /* opaque: the boundary under the input's loads */

/* Dies (exit 2) if a load's edge is not an edge of a body. Collective (same input on all ranks). */
struct solid_edges *solid_edge_load_new(const struct solid_input *in);
void solid_edge_load_free(struct solid_edges *edges);
/* Adds the k-th load, with a factor of 1, to the owned particles' forces: force [s->n] in both directions, N/m3.
 * Collective. */
void solid_edge_load_force(const struct solid *s, struct solid_sites *const *sites, const struct solid_edges *edges,
                           int k, double *const force[2]);
/* The same for a plate with particles of several sizes. of_cloud gives each its part of the edge. Collective. */
void solid_edge_load_force_refined(const struct solid *s, solid_edge_load_lengths *of_cloud, int k,
                                   double *const force[2]);
