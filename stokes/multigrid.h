/* An approximate inverse of a level's matrix by cycles over coarser levels: on each a Gauss-Seidel sweep upwards, one
 * or two steps of conjugate gradients on the next level, each preconditioned by a cycle there, and a sweep downwards
 * (the K-cycle of Notay and Vassilevski 2008). The last level is solved directly. */
#pragma once
#include "stokes/level.h"

struct stokes_multigrid; /* opaque, owned by the caller */

/* fine is borrowed; its member `coarse` is set. Collective. */
struct stokes_multigrid *stokes_multigrid_new(struct stokes_level *fine);
void stokes_multigrid_free(struct stokes_multigrid *m); /* may be NULL. Not collective. */
/* x ~ M^-1 b, both [size] of the finest level; x's ghosts are filled. Collective. */
void stokes_multigrid_cycle(struct stokes_multigrid *m, const float *b, float *x);
