/* Direct solution of the discrete Poisson equation on cell centres: x and y by fast transforms, z by a transform or by
 * tridiagonal systems, over pencils.  (001: secs 3.4.3, 4.1.1) */
#pragma once
#include "fluid/transform.h"
#include <stddef.h>

/* How the last direction, z, is solved. Auto: bands unless z is periodic, which only the transform does. */
enum fluid_poisson_last { FLUID_POISSON_AUTO, FLUID_POISSON_TRANSFORM, FLUID_POISSON_TRIDIAGONAL };

struct fluid_poisson_input {
    int n[3];
    double d[3];              /* m */
    int ranks[3];             /* process grid, as fluid_grid's */
    enum fluid_end end[3][2]; /* of the unknown at the low and high face: value 0 or normal derivative 0 */
    enum fluid_poisson_last last;
    ptrdiff_t row, plane; /* strides of the array that the solution is written to */
};

struct fluid_poisson; /* opaque: plans, eigenvalues, pencils, work */

struct fluid_poisson *fluid_poisson_new(const struct fluid_poisson_input *in); /* Collective. */
void fluid_poisson_free(struct fluid_poisson *p);

/* Plane k of the right-hand side, to be filled by the caller: [m_y][n_x], tight, borrowed. */
double *fluid_poisson_plane(struct fluid_poisson *p, int k);
/* The transforms of plane k that this rank can do alone, while it is in the cache. Not collective. */
void fluid_poisson_plane_forward(struct fluid_poisson *p, int k);
/* Laplacian(q) = the right-hand side, once all planes are forward. q is the array's first cell (no ghosts touched). With no
 * Dirichlet end q has mean zero, and the mean of the right-hand side is ignored. Collective. */
void fluid_poisson_solve(struct fluid_poisson *p, double *q);
