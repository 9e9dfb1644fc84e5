/* The smooth piece of a shape's surface, or of a cavity, that bounds a body next to a particle. */
#pragma once
#include "solid/geometry/piece.h"

/* The one piece that bounds the body towards all the void neighbours of a lattice site x. Returns 0 where it takes
 * several, as along an edge, and for bodies that are not on the lattice. open: bit f, the nearest site in direction f
 * is void. Not collective. */
int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece);
