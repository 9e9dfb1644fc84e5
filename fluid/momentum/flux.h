/* Momentum fluxes through the faces between eight cells of a row and their neighbours to the right, above and behind,
 * each computed once: convection and diffusion together. Two components share the product of their mean velocities at a
 * corner.
 *
 *      ---v----c----v_e--          c   corner of u and v:  (v + v_e)(u + u_n)/4  carries u along y and v along x
 *     |       |       |            C'  centre:             (u + u_e)^2/4         carries u along x
 *     |   C   u   C'  u_e
 *     |       |       |            the same for the corners of u and w, v and w, and the centres above and behind
 *      -------c'-------- */
#pragma once
#include "base/vec.h"
#include <stddef.h>

/* 1/(4 d), 1/m, and nu/d, m/s, both divided by d once more for the divergence: 1/(4 d^2) and nu/d^2. */
struct flux_factors {
    double convect[3], diffuse[3];
};

/* Diffusive flux in less convective flux out: the rate of a component is the sum over x, y, z of its flux here less its
 * flux at the face before, m/s2. */
struct flux {
    vec ux, vx, wx, uy, vy, wy, uz, vz, wz;
};

static inline __attribute__((always_inline)) vec fluid_flux_of(const struct flux_factors *f, int d, vec product,
                                                               vec difference) {
    return f->diffuse[d] * difference - f->convect[d] * product;
}

/* From u, v, w at the first of the eight cells. */
static inline __attribute__((always_inline)) struct flux fluid_flux_at(const struct flux_factors *f, ptrdiff_t row,
                                                                       ptrdiff_t plane, const double *restrict u,
                                                                       const double *restrict v,
                                                                       const double *restrict w) {
    const vec u0 = vec_load(u), ue = vec_load(u + 1), un = vec_load(u + row), ut = vec_load(u + plane);
    const vec v0 = vec_load(v), ve = vec_load(v + 1), vn = vec_load(v + row), vt = vec_load(v + plane);
    const vec w0 = vec_load(w), we = vec_load(w + 1), wn = vec_load(w + row), wt = vec_load(w + plane);
    const vec uv = (v0 + ve) * (u0 + un), uw = (w0 + we) * (u0 + ut), vw = (w0 + wn) * (v0 + vt);
    return (struct flux){.ux = fluid_flux_of(f, 0, (u0 + ue) * (u0 + ue), ue - u0),
                         .vx = fluid_flux_of(f, 0, uv, ve - v0),
                         .wx = fluid_flux_of(f, 0, uw, we - w0),
                         .uy = fluid_flux_of(f, 1, uv, un - u0),
                         .vy = fluid_flux_of(f, 1, (v0 + vn) * (v0 + vn), vn - v0),
                         .wy = fluid_flux_of(f, 1, vw, wn - w0),
                         .uz = fluid_flux_of(f, 2, uw, ut - u0),
                         .vz = fluid_flux_of(f, 2, vw, vt - v0),
                         .wz = fluid_flux_of(f, 2, (w0 + wt) * (w0 + wt), wt - w0)};
}
