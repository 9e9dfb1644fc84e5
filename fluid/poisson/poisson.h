/* Direct solution of the discrete Poisson equation on cell centres: x and y by fast transforms, plane by plane, z by
 * recurrences over the planes that z's ranks share (fluid/poisson/column.h). The transforms of a plane are done while
 * it is in the cache, between whatever makes its right-hand side and whatever uses its solution. With a shift,
 * Helmholtz's equation by the same means.  (001: secs 3.4.3, 4.1) */
#pragma once
#include "fluid/poisson/transform.h"
#include <stddef.h>

enum { FLUID_POISSON_SHIFTS = 3 }; /* at most: one a stage */

struct fluid_poisson_input {
    int n[3];
    double d[3];              /* m */
    int ranks[3];             /* process grid, as fluid_grid's */
    enum fluid_end end[3][2]; /* of the unknown at the low and high face: value 0 or normal derivative 0 */
    ptrdiff_t row;            /* from a row to the next of the planes that the solution is written to */
    int shifts;               /* 0: Poisson's equation; otherwise Helmholtz's, with so many shifts at once */
};

struct fluid_poisson; /* opaque: plans, eigenvalues, columns, work */

struct fluid_poisson *fluid_poisson_new(const struct fluid_poisson_input *in); /* Collective. */
void fluid_poisson_free(struct fluid_poisson *p);

/* From here on the equation is Laplacian(q) - shift q = the right-hand side, shift > 0, 1/m2; which: 0 .. shifts-1
 * keeps what follows from a shift until another is given in its place. Not collective. */
void fluid_poisson_shift(struct fluid_poisson *p, int which, double shift);
/* Plane k of the right-hand side, to be filled by the caller: [m_y][n_x], tight, borrowed. */
double *fluid_poisson_plane(struct fluid_poisson *p, int k);
/* What this rank can do with plane k alone; k = 0, 1, .. in turn. Not collective. */
void fluid_poisson_plane_forward(struct fluid_poisson *p, int k);
/* Once all planes are forward. With no Dirichlet end q gets the mean `mean`, and that of the right-hand side is
 * ignored. Collective. */
void fluid_poisson_solve(struct fluid_poisson *p, double mean);
/* Plane k of q, Laplacian(q) = the right-hand side: [m_y][n_x] from q on; k = m_z, m_z - 1, .. 0 in turn. Plane m_z is
 * the next rank's first, or the image that the end's condition puts there. Not collective. */
void fluid_poisson_plane_backward(struct fluid_poisson *p, int k, double *q);

/* With no Dirichlet end, once all planes are forward: this rank's share of the mean over the last cells in a direction
 * (side 1) or the first (side 0) of the solution that has mean zero; the direction is not periodic. Collective. */
double fluid_poisson_section_mean(struct fluid_poisson *p, int direction, int side);
