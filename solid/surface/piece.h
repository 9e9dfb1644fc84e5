/* The smooth piece of a shape's surface, or of a cavity, that bounds a body next to a particle. */
#pragma once
#include "solid/geometry/compound.h"

/* The one piece that bounds the body towards all the void neighbours of a lattice site x. Returns 0 where it takes
 * several, as along an edge or where two spheres meet. In a body of several shapes the piece's point next to x must lie
 * on the body's surface; of several such pieces the nearest is taken. open: bit f, the nearest site in direction f is
 * void. Not collective. */
int solid_piece_of(struct solid_compound *compound, const double x[3], unsigned open, struct solid_piece *piece);
