/* Lists of the interface's members and of watched particles. For solid/surface/ only. */
#pragma once
#include "solid/surface/surface.h"

struct solid_watch;
/* Examines a particle that has lost bonds, and watches it. Not collective. */
void solid_surface_classify(struct solid *s, struct solid_surface *f, int h, struct solid_watch *w);
/* Makes the lists of interface particles from the flags and the data stored by particle. Not collective. */
void solid_surface_gather(struct solid *s, struct solid_surface *f);
/* Sets normals and faces of the listed particles from the data stored by particle. Not collective. */
void solid_surface_renew(const struct solid *s, struct solid_surface *f);
/* Sets total and set_free, over all ranks; `also` is summed with them and returned. Collective. */
long solid_surface_count(struct solid_surface *f, long also);
