/* Volumes, apertures and conductances of the wet particles. */
#pragma once
#include "cracks/cracks.h"

/* The present displacements of wet particles and ghosts, m, [n + ghosts]: in the work. Collective. */
const cracks_vec *cracks_aperture_displacements(const struct cracks *c);
/* v_h of the present displacements, m3, [n]. Collective. */
void cracks_aperture_volume(const struct cracks *c, double *volume);
/* With pores: the broken bonds' part of v_h, in c->open. Collective. */
void cracks_aperture_open(const struct cracks *c);
/* The crack volumes of the wet particles: v_h, with pores the broken bonds' part of it, [n]. */
const double *cracks_aperture_cracks(const struct cracks *c);
/* v_h/|a_h|, m; may be negative. Not collective. */
double cracks_aperture_of(const struct cracks *c, int i);
/* Sets the apertures and conductances of the work from c->volume. Collective. */
void cracks_aperture_conductance(const struct cracks *c);
/* With a fluid outside, for a substep: closes the links of particles whose struts are all off, unless they are outlets;
 * bounds the others' conductances by that with which a pressure spreads over a hundred spacings. Collective. */
void cracks_aperture_bound(const struct cracks *c, double dt);
