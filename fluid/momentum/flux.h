/* Momentum fluxes through the faces between a vec of cells of a row and their neighbours to the right, above and
 * behind, each computed once: convection and diffusion together. Two components share the product of their mean
 * velocities at a corner.
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

/* Diffusive minus convective flux through the high face, into the cell: the rate of a component is the sum over x, y, z
 * of this flux minus that of the low face, m/s2. */
struct flux {
    vec ux, vx, wx, uy, vy, wy, uz, vz, wz;
};

static inline __attribute__((always_inline)) vec fluid_flux_of(const struct flux_factors *f, int d, vec product,
                                                               vec difference) {
    return vec_less_product(f->diffuse[d] * difference, vec_set(f->convect[d]), product);
}

/* Values of a component in a vec of cells: here and in their neighbours to the right, above and behind. */
struct flux_values {
    vec here, e, n, t;
};

static inline __attribute__((always_inline)) struct flux_values
fluid_flux_load(ptrdiff_t row, ptrdiff_t plane, const double *restrict q, vec here, vec e) {
    return (struct flux_values){here, e, vec_load(q + row), vec_load(q + plane)};
}

static inline __attribute__((always_inline)) struct flux fluid_flux_through(const struct flux_factors *f,
                                                                            const struct flux_values u,
                                                                            const struct flux_values v,
                                                                            const struct flux_values w) {
    const vec uv = (v.here + v.e) * (u.here + u.n), uw = (w.here + w.e) * (u.here + u.t),
              vw = (w.here + w.n) * (v.here + v.t);
    return (struct flux){.ux = fluid_flux_of(f, 0, (u.here + u.e) * (u.here + u.e), u.e - u.here),
                         .vx = fluid_flux_of(f, 0, uv, v.e - v.here),
                         .wx = fluid_flux_of(f, 0, uw, w.e - w.here),
                         .uy = fluid_flux_of(f, 1, uv, u.n - u.here),
                         .vy = fluid_flux_of(f, 1, (v.here + v.n) * (v.here + v.n), v.n - v.here),
                         .wy = fluid_flux_of(f, 1, vw, w.n - w.here),
                         .uz = fluid_flux_of(f, 2, uw, u.t - u.here),
                         .vz = fluid_flux_of(f, 2, vw, v.t - v.here),
                         .wz = fluid_flux_of(f, 2, (w.here + w.t) * (w.here + w.t), w.t - w.here)};
}

/* From u, v, w at the first of the cells. */
static inline __attribute__((always_inline)) struct flux fluid_flux_at(const struct flux_factors *f, ptrdiff_t row,
                                                                       ptrdiff_t plane, const double *restrict u,
                                                                       const double *restrict v,
                                                                       const double *restrict w) {
    return fluid_flux_through(f, fluid_flux_load(row, plane, u, vec_load(u), vec_load(u + 1)),
                              fluid_flux_load(row, plane, v, vec_load(v), vec_load(v + 1)),
                              fluid_flux_load(row, plane, w, vec_load(w), vec_load(w + 1)));
}
