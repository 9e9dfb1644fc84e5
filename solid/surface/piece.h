/* The surface of the shape that a body was cut from: sphere, cylinder, box, cavities. */
#pragma once
#include "solid/state.h"

/* A smooth piece of the surface: the points whose distance from centre, in the directions of the mask only, is radius.
 * Three directions: a sphere or a cavity; two: the side of a cylinder; one: a pair of planes. */
struct solid_piece {
    int mask[3];
    int inside;               /* +1: the material is inside the radius, -1: outside */
    double centre[3], radius; /* m */
};

/* Depth of x below the piece, m, > 0 in the material; the piece's outward unit normal there. Not collective. */
double solid_piece_depth(const struct solid_piece *piece, const double x[3], double normal[3]);

/* The piece that bounds the body towards all void neighbours of a lattice site x. Returns 0 if there are several, as
 * along an edge, or if the shape has none. open: bit f is set if the nearest site in direction f is void. Not
 * collective. */
int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece);
