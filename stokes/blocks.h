/* A cycle of multigrid for the viscous operator over blocks of 2 x 2 x 2 cells, 4 x 4 x 4, ..: a preconditioner of
 * conjugate gradients (stokes/viscous.h). It is symmetric, positive and linear. Blocks do not cross ranks, and what is
 * beyond a rank's blocks counts as 0; sweeps over faces take the values of other ranks from before. A block has one
 * unknown a component, the sum of its faces' rows. With values that are constant in a block differences between blocks
 * are twice too stiff, and so are walls (Braess 1995, Computing 55), which each level makes good in part by
 * STOKES_BLOCKS_SOFTER: of 1, 1.5, 1.7, 1.8 and 2 the numbers from 1.5 to 1.8 take the fewest products. */
#pragma once
#include "stokes/faces.h"

struct stokes_blocks; /* opaque, owned by the caller */

#define STOKES_BLOCKS_SOFTER 1.7F

struct stokes_blocks *stokes_blocks_new(const struct stokes_cells *cells, const struct stokes_faces *faces);
void stokes_blocks_free(struct stokes_blocks *b); /* may be NULL */
/* z ~ A^-1 r.  r, z [size of the cells][3]; z is 0 at closed faces. Collective. */
void stokes_blocks_cycle(struct stokes_blocks *b, const float (*r)[3], float (*z)[3]);
