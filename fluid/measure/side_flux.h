/* The flux of momentum through one side of the domain, with its moments. */
#pragma once
#include "fluid/fluid.h"

/* Which terms of the flux count: convection (1 or 0), and diffusion with this viscosity. */
struct fluid_flux_kind {
    double convection, viscosity; /* 1; m2/s */
};

/* Sums over the advanced faces of a component beside a side. */
struct fluid_side_flux {
    double sum;       /* of the flux, m2/s2 */
    double moment[3]; /* of the flux times the place of its face, from the domain's centre, m3/s2 */
    double velocity;  /* of the component: of these faces, or of those beyond a free side, m/s */
};

/* Of momentum of component c out of the control surface at one side of direction d, less the viscous traction:
 * (q_d q_c - nu dq_c/dx_d) times the outward sign. This rank's share, whether or not the side is on it. Not
 * collective. */
struct fluid_side_flux fluid_side_flux(const struct fluid *f, const double *const q[3], struct fluid_flux_kind kind,
                                       int c, int d, int side);

/* The first and last faces of component c next to one side of direction d, as fluid_boundary_advanced gives them. */
void fluid_side_flux_faces(const struct fluid *f, int c, int d, int side, int low[3], int high[3]);

/* Coordinate a of the face i of component c, from the domain's centre, m. */
static inline double fluid_side_flux_place(const struct fluid_grid *g, int a, int c, int i) {
    return (g->lo[a] + i + (a == c ? 1 : 0.5)) * g->d[a] - 0.5 * g->length[a];
}
