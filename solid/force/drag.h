/* Drag of markers towards given velocities: the part of the fluid's load that depends on the solid's own velocity. It
 * is implicit, so it does not limit the substep.  (docs/design/coupling.md) */
#pragma once

struct solid;
struct solid_attachment;

/* Marker i, with the velocity (N V)_i of its attachment, is under the force Z p (U - p N V) in each direction. */
struct solid_drag {
    struct solid_attachment *markers; /* N, [n] */
    const double *strength;           /* [n] Z, kg/s */
    const double (*u)[3];             /* [n] U, m/s */
    double (*impulse)[3];             /* [n] on the solid since the caller set it to 0, N s */
    const double (*fraction)[3];      /* [n] p, 1 (coupling/interface/markers.h) */
};

/* The drag's impulse over a time dt, once v has all its other changes:
 *
 *     J = dt Z p (U - p N V)/(1 + dt Z p^2 D) ,   V <- V + M^-1 N^T J
 *
 * With D at least the sum over a row of |N M^-1 N^T| the kinetic energy relative to U does not grow, whatever the step,
 * the densities and the number of markers that share a particle. Held particles keep their velocity; their reactions
 * take the impulse. Adds the work to work_load. Collective. */
void solid_drag_kick(struct solid *s, double dt);
