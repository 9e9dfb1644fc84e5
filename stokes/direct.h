/* The matrix of the last level, of all ranks, solved on each of them by Cholesky's factors. */
#pragma once
#include "stokes/level.h"

struct stokes_direct; /* opaque, owned by the caller */

struct stokes_direct *stokes_direct_new(const struct stokes_level *l); /* l is borrowed. Collective. */
void stokes_direct_free(struct stokes_direct *d);                      /* may be NULL. Not collective. */
/* x = M^-1 b, [n] of this rank. Where M is singular, on pores that no given pressure touches, b less its mean there
 * is taken, and x has the mean 0.
 * Collective. */
void stokes_direct_solve(struct stokes_direct *d, const float *b, float *x);
