/* The wetted area.  (001: sec. 3.5.3) */
#pragma once
#include "solid/surface/normal.h"

/* A particle's share of the immersed area at the start, m2: sum over its bare cones of spacing^2 |n_f.e|; for a
 * particle on no lattice volume^(2/3) a face. n_f, at the face between the particle and the void site, is the mean
 * direction of the particle's normal and of the normal at the void site (from the family within two spacings of it).
 * With the normal at the particle's centre, half a spacing inside, the area of a sphere of 7 spacings would be 6 % too
 * small and that of a cavity 5 % too large; with n_f the error is below 1 %. start: the particle's normal in the
 * undeformed, unbroken solid. Not collective. */
double solid_surface_area_share(const struct solid *s, int h, const struct solid_family_view *view,
                                const struct solid_normal_data *start);
/* A_h of a particle that is exposed later, m2. */
double solid_surface_area_fresh(const struct solid *s, int h);
