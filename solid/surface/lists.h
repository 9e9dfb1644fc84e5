/* Lists of interface particles and of particles that have lost bonds. For solid/surface/ only. */
#pragma once
#include "solid/surface/surface.h"

struct solid_cones;
/* Sets the cones of a particle that has lost bonds, and stores them. Not collective. */
void solid_surface_classify(struct solid *s, struct solid_surface *f, int h, struct solid_cones *w);
/* Makes the lists of interface particles from the flags and the data stored by particle. Not collective. */
void solid_surface_gather(struct solid *s, struct solid_surface *f);
/* Sets normals and faces of the listed particles from the data stored by particle. Not collective. */
void solid_surface_renew(const struct solid *s, struct solid_surface *f);
/* Sets total and set_free, over all ranks; `also` is summed with them and returned. Collective. */
long solid_surface_count(struct solid_surface *f, long also);
