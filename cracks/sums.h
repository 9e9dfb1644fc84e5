/* Sums over struts and links, from and to arrays by wet particle. */
#pragma once
#include "cracks/cracks.h"

/* force [n] = B p, N; p [n + ghosts] with current ghosts. */
void cracks_sums_force(const struct cracks *c, const double *p, cracks_vec *force);
/* volume [n] = B^T u, m3; u [n + ghosts] with current ghosts. */
void cracks_sums_volume(const struct cracks *c, const cracks_vec *u, double *volume);
/* With pores: the broken bonds' part of it. */
void cracks_sums_volume_of_cracks(const struct cracks *c, const cracks_vec *u, double *volume);
/* y [n] = dt^2 B^T M^-1 B p, and with flows + dt L p; p [n + ghosts], whose ghosts are updated. Collective. */
void cracks_sums_apply(const struct cracks *c, double dt, int flows, double *p, double *y);
/* y_h += factor sum over links of T_hl (p_h - p_l); p [n + ghosts] with current ghosts, y [n]. */
void cracks_sums_flow(const struct cracks *c, double factor, const double *p, double *y);
