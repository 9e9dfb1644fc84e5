/* The surface of the shape that a body was cut from: ball, cylinder, box, cavities. */
#pragma once
#include "solid/state.h"

/* A smooth piece of it: the points whose distance from centre, in the directions of the mask alone, is radius. Three
 * directions: a ball or a cavity; two: the side of a cylinder; one: a pair of planes. */
struct solid_piece {
    int mask[3];
    int inside;               /* +1: the material is within the radius, -1: beyond it */
    double centre[3], radius; /* m */
};

/* Depth of x below the piece, m, > 0 in the material, and the piece's unit normal out of it there. Not collective. */
double solid_piece_depth(const struct solid_piece *piece, const double x[3], double normal[3]);

/* The one piece that bounds the body towards all the void neighbours of a lattice site x. Returns 0 where it takes
 * several, as along an edge, and for shapes that have none. open: bit f, the nearest site in direction f is void. Not
 * collective. */
int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece);
