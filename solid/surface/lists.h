/* Inside of solid/surface: its lists. */
#pragma once
#include "solid/surface/surface.h"

struct solid_watch;
/* Watches a particle that has lost a nearest neighbour, or renews what is known of it. Not collective. */
void solid_surface_watch(struct solid_surface *f, const struct solid_watch *w);
/* Looks at a particle that has lost bonds, and watches it. Not collective. */
void solid_surface_look(struct solid *s, struct solid_surface *f, int h, struct solid_watch *w);
/* The lists of interface particles, from the flags and what is kept by particle. Not collective. */
void solid_surface_gather(struct solid *s, struct solid_surface *f);
/* Normals and faces of the listed, from what is kept by particle. Not collective. */
void solid_surface_renew(const struct solid *s, struct solid_surface *f);
/* total and set_free, of all ranks; `also` is summed along with them and returned. Collective. */
long solid_surface_count(struct solid_surface *f, long also);
