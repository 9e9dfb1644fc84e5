/* Loads on the edges of plates that are polygons. Inside the room only. */
#pragma once
#include "solid/imposed/given.h"

struct solid_edges; /* opaque: the boundary under the input's loads */

/* Dies (exit 2) where a load's edge is none of a body's. Collective (all ranks alike). */
struct solid_edges *solid_edge_load_new(const struct solid_input *in);
void solid_edge_load_free(struct solid_edges *edges);
/* Adds the k-th load, where its factor is 1, by owned particle: force [s->n] in either direction, N/m3. Collective. */
void solid_edge_load_force(const struct solid *s, struct solid_sites *const *sites, const struct solid_edges *edges,
                           int k, double *const force[2]);
/* The same of a plate whose particles are not all of one size; of_cloud: solid_edge_load_lengths. Collective. */
void solid_edge_load_force_refined(const struct solid *s, solid_edge_load_lengths *of_cloud, int k,
                                   double *const force[2]);
