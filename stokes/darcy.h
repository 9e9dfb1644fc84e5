/* The Darcy operator M = G^T phi G on the pore cells, with phi the velocity that a unit gradient drives at each face:
 * what the Schur complement G^T A^-1 G is like for pressures that vary along many pores. */
#pragma once
#include "stokes/faces.h"

struct stokes_darcy; /* opaque, owned by the caller */

/* phi [size][3], 0 at closed faces, with ghosts filled; on sides of given pressure twice as large. It is freed: half of
 * each float is kept. Collective. */
struct stokes_darcy *stokes_darcy_new(const struct stokes_cells *cells, float (*phi)[3]);
void stokes_darcy_free(struct stokes_darcy *d); /* may be NULL. Not collective. */
/* x = M^-1 b, until a step adds less than tolerance^2 of x.M x to it, by conjugate gradients with a multigrid cycle.
 * b, x [size], the ghosts of x are filled; b is lost; work: three of [size]. Returns the number of cycles. Collective.
 */
int stokes_darcy_solve(struct stokes_darcy *d, double tolerance, float *b, float *x, float *const work[3]);
/* b = G^T phi f, the flow of a force f on component c. Not collective. */
void stokes_darcy_force(const struct stokes_darcy *d, int c, float *b);
