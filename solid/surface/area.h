/* The wetted area.  (001: sec. 3.5.3) */
#pragma once
#include "solid/surface/normal.h"

/* A particle's share of the immersed area at the start, m2: sum over its bare cones of spacing^2 |n_f.e|; off the
 * lattice volume^(2/3) a face. n_f, at the face between the particle and the void site, is the mean direction of the
 * particle's normal and of that seen from the void site (of the family within two spacings of it): a normal at the
 * particle's centre, half a spacing inside, would make a ball of 7 spacings 6 % too small and a cavity 5 % too large;
 * this is within 1 %. start: the particle's normal in the undeformed, unbroken solid. Not collective. */
double solid_surface_area_share(const struct solid *s, int h, const struct solid_family_view *view,
                                const struct solid_facing *start);
/* A_h of a particle exposed later, m2. */
double solid_surface_area_fresh(const struct solid *s, int h);
