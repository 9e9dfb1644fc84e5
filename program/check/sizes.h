/* Which sizes of a scene are too few spacings. */
#pragma once
#include "coupling/run.h"

/* Prints a sentence for each size that is less than docs/choosing.md asks for: walls, holes, cracks, bodies that
 * collide, the horizon of the bilinear law. Prints nothing where all are large enough or the solid does not deform. Not
 * collective: rank 0 prints. */
void check_sizes_print(const struct run *r);
